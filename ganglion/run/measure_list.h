#pragma once

#include <memory>
#include <vector>

#include "ganglion/graph/controller.h"
#include "ganglion/measure/measure.h"
#include "ganglion/run/criterion.h"

namespace ganglion {

/// The signals of a controller as measures see them.
std::vector<MeasuredSignal> measured_signals(const Controller& controller);

/// All figures that kinds of measures have in that scope, in the order of results.
std::vector<Figure> figures_in(const MeasureScope& scope);

/// All measures that apply in a scope, at work on one run.
class MeasureList {
 public:
  explicit MeasureList(const MeasureScope& scope);

  /// Before the first tick; `unhindered` null = there is no yardstick.
  void begin(const Moment& start, const Unhindered* unhindered);
  void update(const Moment& now);
  /// Those for results, in their order; NaN = not known.
  Measures listed() const;
  /// Those with these names, unlisted ones included, for stop rules.
  Measures of(const std::vector<std::string>& names) const;

 private:
  struct Entry {
    std::unique_ptr<Measure> measure;
    std::vector<Figure> figures;
  };
  std::vector<Entry> entries_;
};

}  // namespace ganglion
