#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/application/terrain.h"
#include "ganglion/application/witness.h"
#include "ganglion/descriptor/descriptor.h"
#include "ganglion/descriptor/meaning.h"

namespace ganglion {

/// One number that a measure finds out about a run.
struct Figure {
  std::string name;  ///< As written in criteria: "travelled_m".
  std::string unit;
  Sentence title;
  bool running = true;  ///< Known at every tick: may stand in a stop rule.
  bool listed = true;   ///< In results; others only stop.
  bool sparse = false;  ///< Left out of results where it is not known.
};

/// A signal of the controller, as measures see it.
struct MeasuredSignal {
  std::string name;  ///< "arbiter.share.escape"
  std::string unit;
  Meaning meaning = Meaning::None;
};

/// What can be measured in an experiment: known before anything runs.
struct MeasureScope {
  std::span<const TruthChannel> truth{};  ///< Empty: nobody knows.
  std::span<const MeasuredSignal> signals{};
  std::span<const LedgerForm> ledgers{};  ///< Of the tasks.
  const Terrain* terrain = nullptr;       ///< Null: there is no ground.
  double radius_m = 0;                    ///< Of the robot's own disc.

  /// Index of a truth channel or signal; none where there is no such.
  std::optional<std::size_t> truth_index(std::string_view name) const noexcept;
};

/// One instant of a run.
struct Moment {
  double time_s = 0;
  double step_s = 0;
  std::span<const double> truth{};  ///< Empty: nobody knows.
  std::span<const double> signals{};
  std::span<const Ledger* const> ledgers{};  ///< In the order of the scope's; null where nobody knows it.
};

/// The truth of a run where nothing stands in the robot's way, tick by tick: rows of all channels.
struct Unhindered {
  std::size_t channels = 0;
  std::vector<double> values{};
  std::size_t rows() const noexcept { return channels > 0 ? values.size() / channels : 0; }
  std::span<const double> row(std::size_t n) const noexcept {
    return std::span(values).subspan(n * channels, channels);
  }
};

/// Works one or a few figures out as a run goes by.
class Measure {
 public:
  virtual ~Measure() = default;
  /// Before the first tick. `unhindered` null = there is no yardstick.
  virtual void begin(const Moment& start, const Unhindered* unhindered) {
    static_cast<void>(start);
    static_cast<void>(unhindered);
  }
  /// After each step: the truth now, and what the controller's signals were.
  virtual void update(const Moment& now) = 0;
  /// One value for each of the kind's figures() of the same scope; NaN = not known.
  virtual void report(std::span<double> figures) const = 0;
  /// One of them, for a stop rule at every tick, where that is cheaper than all; none = it is not.
  virtual std::optional<double> value(std::size_t figure) const {
    static_cast<void>(figure);
    return std::nullopt;
  }
};

/// A kind of measure; see ganglion/measure/<kind>/.
struct MeasureKind {
  Descriptor descriptor;
  int order = 0;  ///< Where its figures stand in results.
  /// What it can tell in that scope; empty where it does not apply.
  std::vector<Figure> (*figures)(const MeasureScope&) = nullptr;
  /// Called where it has figures.
  std::unique_ptr<Measure> (*make)(const MeasureScope&) = nullptr;
};

}  // namespace ganglion
