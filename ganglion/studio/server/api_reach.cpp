// Commands that reach into the world of the run that is on.
#include <cmath>
#include <limits>

#include "ganglion/studio/server/api.h"

namespace ganglion::studio {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Reply Api::set_goal(const Ask& ask) {
  const double robot = ask.number("robot", 0);
  if (!(robot >= 0 && robot <= 1e6 && robot == std::floor(robot))) {
    return ask.refuse("BadRequest", "robot must be a whole number from 0 on", 400);
  }
  return intervene(ask, sim::SetGoal{static_cast<int>(robot), {ask.number("x_m", kNan), ask.number("y_m", kNan)}});
}

Reply Api::put_obstacle(const Ask& ask) {
  return intervene(ask, sim::PutMover{ask.text("mover"), {ask.number("x_m", kNan), ask.number("y_m", kNan)}});
}

Reply Api::intervene(const Ask& ask, sim::Intervention what) {
  if (auto refused = refuse_command(ask)) return *refused;
  const bool bad = std::visit([](const auto& one) { return std::isnan(one.point.x + one.point.y); }, what);
  if (bad) return ask.refuse("BadRequest", "x_m and y_m must be numbers", 400);
  if (!session_ || session_->over()) return answer(ask, false);
  const auto done = session_->intervene(what);
  if (!done && done.error().message == kNoTickToCome) {
    return ask.refuse("NotRunning", kNoTickToCome, 409);
  }
  if (!done) return failure(done.error(), ask.language);
  return json_reply(
      {{"x_m", done->point.x}, {"y_m", done->point.y}, {"reachable", done->reachable}, {"state", state()}});
}

}  // namespace ganglion::studio
