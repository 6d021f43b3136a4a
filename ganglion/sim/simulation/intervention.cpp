#include "ganglion/sim/simulation/intervention.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ganglion/base/text.h"
#include "ganglion/sim/simulation/simulation.h"

namespace ganglion::sim {

Result<Intervened> Simulation::intervene(const Intervention& intervention) {
  const Vector2 point = std::visit([](const auto& one) { return one.point; }, intervention);
  if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
    return fail(ErrorCode::BadParameter,
                {"the point is ({}, {}), must be two finite numbers [m]",
                 "el punto es ({}, {}), deben ser dos números finitos [m]"},
                point.x, point.y);
  }
  if (const auto* goal = std::get_if<SetGoal>(&intervention)) return set_goal(*goal);
  return put_mover(std::get<PutMover>(intervention));
}

Result<Intervened> Simulation::set_goal(const SetGoal& wish) {
  if (wish.robot < 0 || wish.robot >= robots()) {
    return fail(ErrorCode::NotFound,
                {"there is no robot {}: they are numbered from 0 to {}", "no existe el robot {}: se numeran de 0 a {}"},
                wish.robot, robots() - 1);
  }
  const auto robot = static_cast<std::size_t>(wish.robot);
  const auto trainer = std::find_if(devices_.begin(), devices_.end(), [&](const Device& device) {
    return device.sensor(robot).trainer_log() != nullptr;
  });
  if (trainer == devices_.end()) {
    return fail(ErrorCode::Unsupported, {"the robot has no trainer that could set it a goal",
                                         "el robot no tiene ningún entrenador que le fije un objetivo"});
  }
  const Box2& bounds = world_.ground().bounds();
  if (!bounds.contains(wish.point)) {
    return fail(ErrorCode::BadParameter,
                {"({:.2f}, {:.2f}) lies outside of the world, from ({}, {}) to ({}, {})",
                 "({:.2f}, {:.2f}) está fuera del mundo, que va de ({}, {}) a ({}, {})"},
                wish.point.x, wish.point.y, bounds.lower.x, bounds.lower.y, bounds.upper.x, bounds.upper.y);
  }
  const Body& body = bodies_[robot];
  const Scene scene{.world = world_,
                    .robot = body.truth(),
                    .heading = body.ahead(),
                    .radius_m = config_.model->radius_m,
                    .tick = tick_,
                    .time_s = time_s_};
  const auto centre = trainer->set_goal(robot, scene, wish.point, values_of(robot));
  if (!centre) return tl::unexpected<Error>(centre.error());
  return Intervened{*centre, std::as_const(*trainer).sensor(robot).trainer_log()->records().back().reachable};
}

Result<Intervened> Simulation::put_mover(const PutMover& wish) {
  const auto movers = world_.movers();
  const auto found =
      std::find_if(movers.begin(), movers.end(), [&](const MoverState& mover) { return mover.id == wish.mover; });
  if (found == movers.end()) {
    std::vector<std::string> ids;
    for (const MoverState& mover : movers) ids.emplace_back(mover.id);
    const Sentence what = say({"the world has no mover \"{}\"{}", "el mundo no tiene el obstáculo móvil \"{}\"{}"},
                              wish.mover, suggestion(wish.mover, ids));
    return tl::unexpected<Error>(Error{ErrorCode::NotFound, what, {}, {.found = wish.mover, .choices = ids}});
  }
  const auto put = world_.put_mover(static_cast<std::size_t>(found - movers.begin()), wish.point, neighbours_.discs());
  if (!put) return tl::unexpected<Error>(put.error());
  return Intervened{wish.point};
}

}  // namespace ganglion::sim
