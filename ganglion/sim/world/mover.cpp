// The movers of a World: where they stand, and when they go elsewhere.
#include <algorithm>
#include <array>

#include "ganglion/base/expects.h"
#include "ganglion/base/hash.h"
#include "ganglion/random/draws.h"
#include "ganglion/sim/world/world.h"

namespace ganglion::sim {
namespace {

constexpr double kMargin_m = 1e-6;  ///< A mover keeps this far from robots at least.

Pose2 first_pose(const MoverPlan& plan) noexcept {
  if (plan.stroll) return {plan.stroll->start, plan.yaw};
  return plan.path.empty() ? plan.places.front() : Pose2{plan.path.front(), plan.yaw};
}

}  // namespace

void World::reset(std::uint64_t seed, std::uint32_t episode) noexcept {
  seed_ = seed;
  episode_ = episode;
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    const MoverPlan& plan = ground_->movers()[i];
    errands_[i] = {.change_s = kNoHit, .corner = errands_[i].corner};
    put(i, first_pose(plan));
    if (plan.places.size() < 2) continue;
    Draws draws({seed_, episode_, 0, combine(hash_name(plan.id), 1)}, 0);
    errands_[i].change_s = draws.uniform(plan.change_min_s, plan.change_max_s);
  }
}

void World::advance(std::uint32_t tick, double time_s, double step_s, std::span<const Disc> robots) noexcept {
  expects(step_s >= 0);
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    if (errands_[i].held) continue;
    if (ground_->movers()[i].stroll) {
      stroll(i, time_s, step_s, robots);
    } else if (!ground_->movers()[i].path.empty()) {
      walk(i, step_s, robots);
    } else if (time_s + step_s > errands_[i].change_s) {
      jump(i, tick, time_s + step_s, robots);
    }
  }
}

void World::jump(std::size_t mover, std::uint32_t tick, double time_s, std::span<const Disc> robots) noexcept {
  const MoverPlan& plan = ground_->movers()[mover];
  Errand& errand = errands_[mover];
  auto open = [&](std::size_t k) { return k != errand.place && free_for(mover, plan.places[k], robots); };
  std::uint32_t choices = 0;
  for (std::size_t k = 0; k < plan.places.size(); ++k) choices += open(k) ? 1 : 0;
  if (choices == 0) return;
  Draws draws({seed_, episode_, 0, hash_name(plan.id)}, tick);
  std::uint32_t chosen = draws.below(choices);
  std::size_t place = 0;
  while (!open(place) || chosen-- > 0) ++place;
  errand.place = place;
  errand.change_s = time_s + draws.uniform(plan.change_min_s, plan.change_max_s);
  put(mover, plan.places[place]);
}

void World::walk(std::size_t mover, double step_s, std::span<const Disc> robots) noexcept {
  const MoverPlan& plan = ground_->movers()[mover];
  Errand& errand = errands_[mover];
  double left_m = plan.speed_mps * step_s;
  const std::size_t count = plan.path.size();
  for (std::size_t legs = 0; left_m > 0 && legs <= count; ++legs) {  // whole rounds within one step are not counted out
    if (errand.place + 1 == count && !plan.loop) return;
    const Vector2 from = plan.path[errand.place], to = plan.path[(errand.place + 1) % count];
    const double leg_m = (to - from).length();
    const double walked_m = std::min(errand.walked_m + left_m, leg_m);
    const Vector2 goal = walked_m == leg_m ? to : from + (to - from) * (walked_m / leg_m);
    if (!way_free(mover, goal - movers_[mover].pose.position, robots)) return;
    left_m -= walked_m - errand.walked_m;
    put(mover, {goal, plan.yaw});
    const bool arrived = walked_m == leg_m;
    errand.walked_m = arrived ? 0 : walked_m;
    if (arrived) errand.place = (errand.place + 1) % count;
  }
}

void World::put(std::size_t mover, const Pose2& pose) noexcept {
  movers_[mover].pose = pose;
  const auto outline = movers_[mover].outline;
  if (outline.empty()) return;
  const Vector2 ahead = direction(pose.yaw.rad());
  for (std::size_t k = 0; k < outline.size(); ++k) {
    corners_[errands_[mover].corner + k] = pose.position + ahead * outline[k].x + ahead.left() * outline[k].y;
  }
}

/// Neither a robot nor another mover stands there. Instead of moving it, everything else is seen from it.
bool World::free_for(std::size_t mover, const Pose2& pose, std::span<const Disc> robots) const noexcept {
  if (std::any_of(robots.begin(), robots.end(), [&](const Disc& robot) { return meets(mover, pose, robot); })) {
    return false;
  }
  for (std::size_t other = 0; other < movers_.size(); ++other) {
    if (other != mover && overlaps(mover, pose, other)) return false;
  }
  return true;
}

bool World::meets(std::size_t mover, const Pose2& pose, const Disc& robot) const noexcept {
  const Vector2 seen = movers_[mover].pose.to_outer(pose.to_local(robot.position));
  return mover_contains(mover, seen) || distance_to(mover, seen) < robot.radius_m + kMargin_m;
}

bool World::overlaps(std::size_t mover, const Pose2& pose, std::size_t other) const noexcept {
  const double apart_m = (movers_[other].pose.position - pose.position).length();
  if (apart_m >= movers_[other].radius_m + movers_[mover].radius_m) return false;
  const auto mine = corners(mover), theirs = corners(other);
  if (mine.empty() && theirs.empty()) return true;
  const Pose2& present = movers_[mover].pose;
  if (theirs.empty()) {
    const Vector2 seen = present.to_outer(pose.to_local(movers_[other].pose.position));
    return mover_contains(mover, seen) || distance_to(mover, seen) < movers_[other].radius_m;
  }
  if (mine.empty())
    return mover_contains(other, pose.position) || distance_to(other, pose.position) < movers_[mover].radius_m;
  std::array<Vector2, 4> seen;
  for (std::size_t k = 0; k < theirs.size(); ++k) seen[k] = present.to_outer(pose.to_local(theirs[k]));
  return convex_overlap(mine, seen);
}

/// Whether it can be carried straight along `displacement` without meeting a robot: as if the robots came the other
/// way.
bool World::way_free(std::size_t mover, Vector2 displacement, std::span<const Disc> robots) const noexcept {
  for (const Disc& robot : robots) {
    Contact first;
    sweep_mover(mover, robot.position, -displacement, robot.radius_m + kMargin_m, first);
    if (first.happened()) return false;
  }
  return true;
}

std::span<const Vector2> World::corners(std::size_t mover) const noexcept {
  return {corners_.data() + errands_[mover].corner, movers_[mover].outline.size()};
}

double World::distance_to(std::size_t mover, Vector2 point) const noexcept {
  const auto outline = corners(mover);
  if (outline.empty()) return std::fabs((point - movers_[mover].pose.position).length() - movers_[mover].radius_m);
  double distance_m = kNoHit;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vector2 nearest = nearest_on_segment(point, outline[k], outline[(k + 1) % outline.size()]);
    distance_m = std::min(distance_m, (point - nearest).length());
  }
  return distance_m;
}

double World::mover_clearance(std::size_t mover, Vector2 point) const noexcept {
  const double distance_m = distance_to(mover, point);
  return mover_contains(mover, point) ? -distance_m : distance_m;
}

bool World::mover_contains(std::size_t mover, Vector2 point) const noexcept {
  const Vector2 away = point - movers_[mover].pose.position;
  if (away.squared() >= movers_[mover].radius_m * movers_[mover].radius_m) return false;
  return movers_[mover].outline.empty() || outline_contains(corners(mover), point);
}

void World::sweep_mover(std::size_t mover, Vector2 from, Vector2 displacement, double radius_m,
                        Contact& first) const noexcept {
  const Disc disc = disc_of(mover);
  const double reach_m = disc.radius_m + radius_m + displacement.length();
  if ((from - disc.position).squared() > reach_m * reach_m) return;
  const auto outline = corners(mover);
  if (outline.empty()) return sweep_disc(from, displacement, radius_m, disc, first);
  for (std::size_t k = 0; k < outline.size(); ++k) {
    sweep_segment(from, displacement, radius_m, outline[k], outline[(k + 1) % outline.size()], first);
  }
}

}  // namespace ganglion::sim
