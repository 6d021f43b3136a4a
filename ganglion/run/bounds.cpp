#include "ganglion/run/bounds.h"

#include <algorithm>
#include <cmath>

#include "ganglion/base/text.h"
#include "ganglion/link/wire/framing.h"

namespace ganglion {
namespace {

void check_ticks(const Prepared& prepared, Problems& problems) {
  const Experiment& experiment = prepared.experiment;
  const double ticks = ticks_of(prepared);
  if (ticks > kMostTicks) {
    problems.add(experiment.places.duration, ErrorCode::TooLarge,
                 {"{} s in ticks of {} s are {:.0f} ticks; the limit is {:.0f}",
                  "{} s en ciclos de {} s son {:.0f} ciclos; el límite es {:.0f}"},
                 shortest(experiment.duration_s), shortest(prepared.step_s), ticks, kMostTicks);
    return;
  }
  const double kept = ticks * static_cast<double>(prepared.application->truth().size());
  if (experiment.free_ground && kept > kMostFreeValues) {
    problems.add(experiment.places.free_ground, ErrorCode::TooLarge,
                 {"the run on open ground keeps {:.0f} values in {:.0f} ticks; the limit is {:.0f}: shorten duration_s",
                  "la ejecución en terreno libre guarda {:.0f} valores en {:.0f} ciclos; el límite es {:.0f}: acorte "
                  "duration_s"},
                 kept, ticks, kMostFreeValues);
  }
}

/// As the link carries it in binary: eight bytes for each value and each age of the sensations, or for each value of the
/// commands with a time to live.
double frame_bytes(const Description& robot) noexcept {
  const auto sense = static_cast<double>(robot.sensation_values()) + static_cast<double>(robot.sensations.size());
  const auto act = static_cast<double>(robot.command_values()) + static_cast<double>(robot.commands.size());
  return 8 * std::max(sense, act);
}

void check_robots(const Prepared& prepared, Problems& problems) {
  const Experiment& experiment = prepared.experiment;
  const double robots = experiment.robots;
  double values = prepared.application->description().sensation_values();
  for (const ComponentModel& component : prepared.controller.components) {
    for (const OutputShape& output : component.outputs) values += output.size();
  }
  if (robots * values > kMostRobotValues) {
    problems.add(experiment.places.robots, ErrorCode::TooLarge,
                 {"the controllers of {} robots have {:.0f} values; the limit is {:.0f}",
                  "los controladores de {} robots tienen {:.0f} valores; el límite es {:.0f}"},
                 experiment.robots, robots * values, kMostRobotValues);
  }
}

}  // namespace

double ticks_of(const Prepared& prepared) noexcept {
  return std::max(1.0, std::round(prepared.experiment.duration_s / prepared.step_s));
}

void check_frames(const Prepared& prepared, Problems& problems) {
  const Experiment& experiment = prepared.experiment;
  const double bytes = experiment.robots * frame_bytes(prepared.application->description());
  if (bytes <= static_cast<double>(link::kMaxFrameBytes)) return;
  problems.add(experiment.places.robots, ErrorCode::TooLarge,
               {"a frame of {} robot{} has {:.0f} bytes; the limit of the link is {}",
                "una trama de {} robot{} tiene {:.0f} bytes; el límite del enlace es {}"},
               experiment.robots, experiment.robots == 1 ? "" : "s", bytes, link::kMaxFrameBytes);
}

void check_bounds(const Prepared& prepared, Problems& problems) {
  check_ticks(prepared, problems);
  check_robots(prepared, problems);
  if (prepared.experiment.link.remote()) return check_frames(prepared, problems);
  if (const auto fits = prepared.application->fits(prepared.step_s); !fits) problems.add(fits.error());
}

}  // namespace ganglion
