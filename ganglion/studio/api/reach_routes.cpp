#include "ganglion/studio/api/reach_routes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ganglion::studio {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Reply intervene(const Ask& ask, CurrentRun& run, const Intervention& what) {
  if (auto refused = run.refuse_command(ask)) return *refused;
  const bool bad = std::ranges::any_of(what.arguments, [](const NamedNumber& one) { return std::isnan(one.value); });
  if (bad) return ask.refuse("BadRequest", say({"x_m and y_m must be numbers", "x_m e y_m deben ser números"}), 400);
  if (!run.is_on()) return run.answer(ask, false);
  const auto done = run.session()->intervene(what);
  if (!done) {
    return ask.refuse("NotRunning",
                      say({"the run is not going; nothing can be done to its world now",
                           "la ejecución no está en marcha; ahora no se puede hacer nada en su mundo"}),
                      409);
  }
  if (!*done) return failure(done->error(), ask.language);
  const Intervened& now = **done;
  return json_reply({{"x_m", now.argument("x_m")},
                     {"y_m", now.argument("y_m")},
                     {"reachable", now.reachable},
                     {"state", run.state()}});
}

std::vector<NamedNumber> point_of(const Ask& ask) {
  return {{"x_m", ask.number("x_m", kNan)}, {"y_m", ask.number("y_m", kNan)}};
}

Reply set_goal(const Ask& ask, CurrentRun& run) {
  const double robot = ask.number("robot", 0);
  if (!(robot >= 0 && robot <= 1e6 && robot == std::floor(robot))) {
    return ask.refuse("BadRequest",
                      say({"robot must be a whole number from 0 on", "robot debe ser un número entero desde 0"}), 400);
  }
  return intervene(ask, run, {"goal", static_cast<int>(robot), "", point_of(ask)});
}

Reply put_obstacle(const Ask& ask, CurrentRun& run) {
  return intervene(ask, run, {"obstacle", 0, ask.text("mover"), point_of(ask)});
}

}  // namespace

void add_reach_routes(Router& router, CurrentRun& run) {
  router.post("/api/run/goal", [&run](const Ask& ask) { return set_goal(ask, run); });
  router.post("/api/run/obstacle", [&run](const Ask& ask) { return put_obstacle(ask, run); });
}

}  // namespace ganglion::studio
