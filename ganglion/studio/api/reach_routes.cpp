#include "ganglion/studio/api/reach_routes.h"

#include <cmath>
#include <limits>

namespace ganglion::studio {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Reply intervene(const Ask& ask, CurrentRun& run, const sim::Intervention& what) {
  if (auto refused = run.refuse_command(ask)) return *refused;
  const bool bad = std::visit([](const auto& one) { return std::isnan(one.point.x + one.point.y); }, what);
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
  const sim::Intervened& now = **done;
  return json_reply({{"x_m", now.point.x}, {"y_m", now.point.y}, {"reachable", now.reachable}, {"state", run.state()}});
}

Reply set_goal(const Ask& ask, CurrentRun& run) {
  const double robot = ask.number("robot", 0);
  if (!(robot >= 0 && robot <= 1e6 && robot == std::floor(robot))) {
    return ask.refuse("BadRequest",
                      say({"robot must be a whole number from 0 on", "robot debe ser un número entero desde 0"}), 400);
  }
  return intervene(ask, run, sim::SetGoal{static_cast<int>(robot), {ask.number("x_m", kNan), ask.number("y_m", kNan)}});
}

Reply put_obstacle(const Ask& ask, CurrentRun& run) {
  return intervene(ask, run, sim::PutMover{ask.text("mover"), {ask.number("x_m", kNan), ask.number("y_m", kNan)}});
}

}  // namespace

void add_reach_routes(Router& router, CurrentRun& run) {
  router.post("/api/run/goal", [&run](const Ask& ask) { return set_goal(ask, run); });
  router.post("/api/run/obstacle", [&run](const Ask& ask) { return put_obstacle(ask, run); });
}

}  // namespace ganglion::studio
