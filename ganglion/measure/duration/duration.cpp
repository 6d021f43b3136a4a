#include "ganglion/measure/measure.h"

namespace ganglion {
namespace {

/// Time since the run began.
class Duration final : public Measure {
 public:
  void update(const Moment& now) override { time_s_ = now.time_s; }
  void report(std::span<double> figures) const override { figures[0] = time_s_; }

 private:
  double time_s_ = 0;
};

}  // namespace

extern constinit const MeasureKind duration_kind{
    .descriptor = {.component_class = ComponentClass::Measure,
                   .name = "Duration",
                   .summary = {"Time of the run: duration_s", "Tiempo de la ejecución: duration_s"},
                   .source = "ours"},
    .order = 0,
    .figures = [](const MeasureScope&) -> std::vector<Figure> {
      return {{.name = "duration_s", .unit = "s", .title = say({"time simulated", "tiempo simulado"})}};
    },
    .make = [](const MeasureScope&) -> std::unique_ptr<Measure> { return std::make_unique<Duration>(); }};

}  // namespace ganglion
