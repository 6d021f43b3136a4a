// Movers of a World that somebody puts elsewhere while it runs.
#include <array>

#include "ganglion/sim/world/ray/ray.h"
#include "ganglion/sim/world/world.h"

namespace ganglion::sim {
namespace {

constexpr double kStandingAt_m = 1e-9;  // it may stand right at a wall

}  // namespace

Result<void> World::put_mover(std::size_t mover, Vector2 point, std::span<const Disc> robots) {
  const MoverPlan& plan = ground_->movers()[mover];
  const Pose2 pose{point, movers_[mover].pose.yaw};
  const Box2& bounds = ground_->bounds();
  if (!bounds.contains(point)) {
    return fail(ErrorCode::BadParameter,
                {"({:.2f}, {:.2f}) lies outside of the world, from ({}, {}) to ({}, {})",
                 "({:.2f}, {:.2f}) está fuera del mundo, que va de ({}, {}) a ({}, {})"},
                point.x, point.y, bounds.lower.x, bounds.lower.y, bounds.upper.x, bounds.upper.y);
  }
  const auto refuse = [&](const Sentence& what) {
    return fail(ErrorCode::BadParameter,
                {"\"{}\" cannot stand at ({:.2f}, {:.2f}): {}", "\"{}\" no puede estar en ({:.2f}, {:.2f}): {}"},
                plan.id, point.x, point.y, what);
  };
  if (meets_ground(mover, pose))
    return refuse(say({"a wall or something solid is there", "hay una pared o algo sólido"}));
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (meets(mover, pose, robots[i])) return refuse(say({"robot {} is there", "está el robot {}"}, i));
  }
  for (std::size_t other = 0; other < movers_.size(); ++other) {
    if (other != mover && overlaps(mover, pose, other)) {
      return refuse(say({"\"{}\" is there", "está \"{}\""}, movers_[other].id));
    }
  }
  put(mover, pose);
  errands_[mover].held = !plan.stroll.has_value();
  errands_[mover].walking = false;  // a stroll: to another goal, from here
  errands_[mover].resume_s = 0;
  return {};
}

/// Surfaces that run through it, and solids round all of it.
bool World::meets_ground(std::size_t mover, const Pose2& pose) const noexcept {
  if (ground_->inside_solid(pose.position)) return true;
  const MoverState& shape = movers_[mover];
  if (shape.outline.empty()) {
    return ground_->clearance(pose.position, shape.radius_m) < shape.radius_m - kStandingAt_m;
  }
  std::array<Vector2, 4> corners;
  for (std::size_t k = 0; k < shape.outline.size(); ++k) corners[k] = pose.to_outer(shape.outline[k]);
  Box2 box = empty_box();
  for (const Vector2 corner : corners) box.include(corner);
  bool meets = false;
  ground_->surfaces().visit(
      box,
      [&](const Segment& segment) {
        const std::array<Vector2, 2> ends = {segment.from, segment.to};
        meets = meets || convex_overlap(corners, ends);
      },
      [&](const RoundSurface& round) {
        const Vector2 seen = pose.to_local(round.disc.position);
        meets = meets || outline_contains(shape.outline, seen);
        for (std::size_t k = 0; k < corners.size(); ++k) {
          const Vector2 point = nearest_on_segment(round.disc.position, corners[k], corners[(k + 1) % corners.size()]);
          meets = meets || (point - round.disc.position).length() < round.disc.radius_m;
        }
      });
  return meets;
}

}  // namespace ganglion::sim
