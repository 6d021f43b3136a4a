#pragma once

#include <initializer_list>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/expects.h"
#include "ganglion/measure/measure.h"

namespace ganglion::testing {

/// Channels of these names, for a scope by hand.
inline std::vector<TruthChannel> channels(std::initializer_list<std::string_view> names) {
  std::vector<TruthChannel> list;
  for (const std::string_view name : names) list.push_back({.name = std::string(name), .unit = "", .title = {}});
  return list;
}

/// What a kind can tell in a scope.
inline std::vector<std::string> figure_names(const MeasureKind& kind, const MeasureScope& scope) {
  std::vector<std::string> names;
  for (const Figure& figure : kind.figures(scope)) names.push_back(figure.name);
  return names;
}

/// Ground with one wall, all along x = wall_x_m.
class WalledTerrain final : public Terrain {
 public:
  explicit WalledTerrain(double wall_x_m = std::numeric_limits<double>::infinity(), bool slopes = false) noexcept
      : wall_x_m_(wall_x_m), slopes_(slopes) {}
  Box2 bounds() const noexcept override { return {{-100, -100}, {100, 100}}; }
  double clearance_m(Vector2, double up_to_m) const noexcept override { return up_to_m; }
  bool way_free(Vector2, Vector2, double) const noexcept override { return true; }
  double far_wall_m(Vector2 from, Vector2 towards) const noexcept override {
    const bool ahead = (wall_x_m_ - from.x) * towards.x > 0;
    return ahead ? (wall_x_m_ - from.x) / towards.x : std::numeric_limits<double>::infinity();
  }
  bool slopes() const noexcept override { return slopes_; }

 private:
  double wall_x_m_;
  bool slopes_;
};

/// Drives one measure by hand: a row of truth and one of signals at each tick, figures by name whenever one likes.
class MeasureBench {
 public:
  MeasureBench(const MeasureKind& kind, const MeasureScope& scope, double step_s = 1)
      : figures_(kind.figures(scope)), step_s_(step_s) {
    expects(!figures_.empty());
    measure_ = kind.make(scope);
  }

  /// The ledger that is shown from now on.
  void show(const Ledger* ledger) noexcept { ledger_ = ledger; }
  void begin(std::initializer_list<double> truth, const Unhindered* unhindered = nullptr) {
    measure_->begin(moment(truth, {}), unhindered);
  }
  void step(std::initializer_list<double> truth, std::initializer_list<double> signals = {}) {
    ++ticks_;
    measure_->update(moment(truth, signals));
  }
  double figure(std::string_view name) const {
    std::vector<double> values(figures_.size(), kUntold);
    measure_->report(values);
    std::size_t i = 0;
    while (i < figures_.size() && figures_[i].name != name) ++i;
    expects(i < figures_.size());
    return values[i];
  }

 private:
  static constexpr double kUntold = -1e300;  // not NaN: that would be an answer

  Moment moment(std::initializer_list<double> truth, std::initializer_list<double> signals) const noexcept {
    return {.time_s = ticks_ * step_s_,
            .step_s = step_s_,
            .truth = {truth.begin(), truth.size()},
            .signals = {signals.begin(), signals.size()},
            .ledgers = {&ledger_, 1}};
  }

  std::vector<Figure> figures_;
  std::unique_ptr<Measure> measure_;
  double step_s_;
  int ticks_ = 0;
  const Ledger* ledger_ = nullptr;
};

}  // namespace ganglion::testing
