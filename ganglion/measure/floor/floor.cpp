#include <limits>

#include "ganglion/measure/measure.h"

namespace ganglion {
namespace {

/// Time on ground that is too steep, where the ground has slopes.
class FloorTimes final : public Measure {
 public:
  FloorTimes(std::size_t stalled, std::size_t tipped) : stalled_(stalled), tipped_(tipped) {}
  void update(const Moment& now) override {
    if (now.truth.empty()) return;
    known_ = true;
    step_s_ = now.step_s;
    if (now.truth[stalled_] != 0) ++stalled_ticks_;
    if (now.truth[tipped_] != 0) ++tipped_ticks_;
  }
  void report(std::span<double> figures) const override {
    figures[0] = known_ ? stalled_ticks_ * step_s_ : std::numeric_limits<double>::quiet_NaN();
    figures[1] = known_ ? tipped_ticks_ * step_s_ : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  std::size_t stalled_, tipped_;
  bool known_ = false;
  double step_s_ = 0;
  double stalled_ticks_ = 0;
  double tipped_ticks_ = 0;
};

}  // namespace

extern constinit const MeasureKind floor_kind{
    .descriptor = {.component_class = ComponentClass::Measure,
                   .name = "Floor",
                   .summary = {"Where the ground has slopes, time on those too steep to climb and time fallen over: "
                               "stalled_s, tipped_s",
                               "Donde el suelo tiene pendientes, tiempo en las demasiado empinadas y tiempo volcado: "
                               "stalled_s, tipped_s"},
                   .source = "ours"},
    .order = 6,
    .figures = [](const MeasureScope& scope) -> std::vector<Figure> {
      const bool known = scope.truth_index("stalled") && scope.truth_index("tipped");
      if (!known || scope.terrain == nullptr || !scope.terrain->slopes()) return {};
      return {{.name = "stalled_s",
               .unit = "s",
               .title = say({"time on ground too steep to climb", "tiempo en suelo demasiado empinado"})},
              {.name = "tipped_s", .unit = "s", .title = say({"time fallen over", "tiempo volcado"})}};
    },
    .make = [](const MeasureScope& scope) -> std::unique_ptr<Measure> {
      return std::make_unique<FloorTimes>(*scope.truth_index("stalled"), *scope.truth_index("tipped"));
    }};

}  // namespace ganglion
