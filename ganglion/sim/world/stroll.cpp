// Movers of a World that walk about as people do.
#include <algorithm>

#include "ganglion/base/hash.h"
#include "ganglion/random/draws.h"
#include "ganglion/sim/world/world.h"

namespace ganglion::sim {
namespace {

constexpr int kTries = 32;        // goals drawn before it gives up for a while
constexpr double kRest_s = 0.5;   // that while
constexpr double kLookout_s = 1;  // one that avoids robots looks so far ahead

}  // namespace

void World::stroll(std::size_t mover, double time_s, double step_s, std::span<const Disc> robots) noexcept {
  const MoverPlan& plan = ground_->movers()[mover];
  Errand& errand = errands_[mover];
  if (time_s + step_s <= errand.resume_s) return;
  const auto ahead = [&](double within_s) {
    const Vector2 way = errand.goal - movers_[mover].pose.position;
    const double way_m = way.length(), reach_m = plan.speed_mps * within_s;
    return way_m > reach_m ? way * (reach_m / way_m) : way;
  };
  const bool shies = plan.stroll->avoids_robots && errand.walking && !way_free(mover, ahead(kLookout_s), robots);
  if (!errand.walking || shies) errand.walking = choose_goal(mover, robots);
  if (!errand.walking) {
    errand.resume_s = time_s + kRest_s;
    return;
  }
  const Vector2 step = ahead(step_s);
  if (!way_free(mover, step, robots)) return;  // waits
  const bool arrived = step == errand.goal - movers_[mover].pose.position;
  put(mover, {arrived ? errand.goal : movers_[mover].pose.position + step, plan.yaw});
  if (!arrived) return;
  errand.walking = false;
  errand.resume_s = time_s + step_s + errand.pause_s;
}

bool World::choose_goal(std::size_t mover, std::span<const Disc> robots) noexcept {
  const MoverPlan& plan = ground_->movers()[mover];
  const Stroll& stroll = *plan.stroll;
  Errand& errand = errands_[mover];
  const Vector2 from = movers_[mover].pose.position;
  Draws draws({seed_, episode_, 0, combine(hash_name(plan.id), 2)}, errand.goals++);
  errand.pause_s = draws.uniform(stroll.pause_min_s, stroll.pause_max_s);
  for (int n = 0; n < kTries; ++n) {
    const double x = draws.uniform(stroll.area.lower.x, stroll.area.upper.x);
    errand.goal = {x, draws.uniform(stroll.area.lower.y, stroll.area.upper.y)};
    const Vector2 way = errand.goal - from;
    Contact first;
    ground_->sweep(from, way, plan.radius_m, first);
    const double begin = std::min(1.0, plan.speed_mps * kLookout_s / std::max(way.length(), 1e-9));
    const bool clear = !stroll.avoids_robots || way_free(mover, way * begin, robots);
    if (!first.happened() && clear) return true;
  }
  return false;
}

}  // namespace ganglion::sim
