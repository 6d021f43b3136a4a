#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ganglion/measure/measure.h"

namespace ganglion {
namespace {

constexpr double kBand = 0.02;  // of the step: nearer counts as settled
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Places {
  std::size_t ledger = 0, time_s = 0, setpoint = 0;  // the ledger and its columns
  std::size_t value = 0;                             // of the truth
};

/// The first ledger of set-points, whatever task keeps it, beside a truth that has the value.
std::optional<Places> places_in(const MeasureScope& scope) {
  const auto value = scope.truth_index("value");
  for (std::size_t n = 0; n < scope.ledgers.size() && value; ++n) {
    const auto time = scope.ledgers[n].column("time_s"), setpoint = scope.ledgers[n].column("setpoint");
    if (time && setpoint) return Places{n, *time, *setpoint, *value};
  }
  return std::nullopt;
}

struct SetPointFigure {
  std::string_view name, unit;
  Text title;
};
constexpr std::array kFigures = {
    SetPointFigure{"overshoot",
                   "",
                   {"how far the value went past a set-point, as a share of the step; the worst",
                    "cuánto pasó el valor de una consigna, como parte del escalón; lo peor"}},
    SetPointFigure{"settling_s",
                   "s",
                   {"time until the value stayed within 2 % of the step; the longest",
                    "tiempo hasta que el valor quedó dentro del 2 % del escalón; el más largo"}},
    SetPointFigure{
        "mean_error", "", {"mean distance of the value from the set-point", "distancia media del valor a la consigna"}},
};

/// How well a value was held at set-points.
class SetPoint final : public Measure {
 public:
  explicit SetPoint(const Places& at) : at_(at) {}
  void begin(const Moment& start, const Unhindered*) override {
    value_ = start.truth.empty() ? kNan : start.truth[at_.value];
  }

  void update(const Moment& now) override {
    const Ledger* asked = now.ledgers[at_.ledger];
    if (asked == nullptr || asked->rows() == 0 || now.truth.empty()) return;
    // A set-point of this very moment was not held yet: what counts until now is the one before.
    const std::size_t newest = asked->rows() - 1;
    const bool fresh = newest != row_ && asked->at(newest, at_.time_s) >= now.time_s;
    follow(*asked, fresh ? newest - 1 : newest, now);
    value_ = now.truth[at_.value];
  }

  void report(std::span<double> figures) const override {
    const bool told = steps_ > 0;
    figures[0] = told ? std::max(overshoot_, step_overshoot_) : kNan;
    figures[1] = told && !never_settled_ && !outside_ ? std::max(settling_s_, step_settling_s_) : kNan;
    figures[2] = told_s_ > 0 ? error_s_ / told_s_ : kNan;
  }

 private:
  void follow(const Ledger& asked, std::size_t row, const Moment& now) {
    if (!begun_ || row != row_) begin_step(asked, row);
    const double setpoint = asked.at(row, at_.setpoint), off = now.truth[at_.value] - setpoint;
    error_s_ += std::fabs(off) * now.step_s;
    told_s_ += now.step_s;
    if (span_ == 0) return;
    step_overshoot_ = std::max(step_overshoot_, off / span_);
    outside_ = std::fabs(off) > kBand * std::fabs(span_);
    if (outside_) step_settling_s_ = now.time_s - asked.at(row, at_.time_s);
  }
  /// What the last step came to counts; the next one begins from the value as it was.
  void begin_step(const Ledger& asked, std::size_t row) {
    overshoot_ = std::max(overshoot_, step_overshoot_);
    settling_s_ = std::max(settling_s_, step_settling_s_);
    never_settled_ = never_settled_ || outside_;
    begun_ = true;
    row_ = row;
    span_ = asked.at(row, at_.setpoint) - value_;
    step_overshoot_ = step_settling_s_ = 0;
    outside_ = false;
    if (span_ != 0) ++steps_;
  }

  Places at_;
  double value_ = kNan;  // a tick ago
  bool begun_ = false;
  std::size_t row_ = 0;
  double span_ = 0;
  std::size_t steps_ = 0;
  double step_overshoot_ = 0, step_settling_s_ = 0;
  bool outside_ = false;
  double overshoot_ = 0, settling_s_ = 0;
  bool never_settled_ = false;
  double error_s_ = 0, told_s_ = 0;
};

}  // namespace

extern constinit const MeasureKind set_point_kind{
    .descriptor = {.component_class = ComponentClass::Measure,
                   .name = "SetPoint",
                   .summary = {"How well a value is held at set-points: overshoot, settling_s, mean_error",
                               "Qué bien se mantiene un valor en sus consignas: overshoot, settling_s, mean_error"},
                   .source = "the usual figures of step responses; the band of 2 % as well"},
    .order = 9,
    .figures =
        [](const MeasureScope& scope) {
          std::vector<Figure> list;
          if (!places_in(scope)) return list;
          for (const SetPointFigure& one : kFigures) {
            list.push_back({std::string(one.name), std::string(one.unit), say({"{}", "{}"}, one.title)});
          }
          return list;
        },
    .make = [](const MeasureScope& scope) -> std::unique_ptr<Measure> {
      return std::make_unique<SetPoint>(*places_in(scope));
    }};

}  // namespace ganglion
