#include "ganglion/sim/simulation/floor_ride.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ganglion/base/hash.h"
#include "ganglion/math/functions.h"

namespace ganglion::sim {
namespace {

double grade_of(double slope_rad) noexcept {
  return slope_rad < kPi / 2 ? math::tan(slope_rad) : std::numeric_limits<double>::infinity();
}

/// A movement whose sides lose those shares of their ways.
Movement slipping(Movement movement, double left_share, double right_share, double width_m) noexcept {
  const double mean = (left_share + right_share) / 2;
  const double apart = (right_share - left_share) / 2;
  movement.displacement = movement.displacement * (1 - mean);
  movement.turn_rad = movement.turn_rad * (1 - mean) - apart * (movement.left_m + movement.right_m) / width_m;
  return movement;
}

}  // namespace

FloorRide::FloorRide(const RobotModel& model) noexcept
    : model_(&model),
      climb_grade_(grade_of(model.climb_rad)),
      climb_sine_(math::sin(model.climb_rad)),
      tip_grade_(grade_of(model.tip_rad)) {}

void FloorRide::reset(const StreamId& stream) noexcept {
  stream_ = stream;
  steps_ = jolts_ = 0;
}

void FloorRide::begin() noexcept { ++steps_; }

/// A movement along which the floor rises by `rise` for each metre of the plan.
Movement FloorRide::laden(Movement movement, double rise) const noexcept {
  const double sine = rise / std::sqrt(1 + rise * rise);
  const double load = sine < climb_sine_ ? sine / climb_sine_ : 1;  // climb_sine_ may be 0
  movement.effort *= std::max(0.0, 1 + load);
  if (load <= 0) return movement;
  const double lost_m = load * (movement.left_m + movement.right_m) / 2;
  movement.left_m -= lost_m;
  movement.right_m -= lost_m;
  movement.displacement = movement.displacement * (1 - load);
  return movement;
}

Movement FloorRide::over(const Floor& floor, const Movement& wanted, Truth& truth) noexcept {
  truth.stalled = false;
  const FloorZone* zone = floor.zone_at(truth.pose.position);
  if (zone == nullptr && !truth.tipped) return wanted;
  truth.tipped = truth.tipped || zone->grade > tip_grade_;
  Movement movement = wanted;
  if (truth.tipped) {
    movement.displacement = {};
    movement.turn_rad = 0;
    return movement;
  }
  const double way_m = movement.displacement.length();
  const double rise = way_m > 0 ? movement.displacement.dot(zone->uphill) / way_m * zone->grade : 0;
  const bool too_steep = rise > climb_grade_;
  if (rise != 0 && !too_steep) movement = laden(movement, rise);
  if (zone->slip > 0 || zone->slip_spread > 0) {
    Draws draws(stream_, steps_);
    const double left = std::clamp(zone->slip + zone->slip_spread * draws.normal(), 0.0, 1.0);
    const double right = std::clamp(zone->slip + zone->slip_spread * draws.normal(), 0.0, 1.0);
    movement = slipping(movement, left, right, model_->description.body->width_m);
  }
  if (too_steep) {
    movement.displacement = {};
    truth.stalled = true;
  }
  return movement;
}

double FloorRide::jolt_rad(const Floor& floor, Vector2 before, Vector2 after) noexcept {
  double turn_rad = 0;
  for (const FloorBump& bump : floor.bumps) {
    if (!crosses(bump, before, after)) continue;
    StreamId stream = stream_;
    stream.component = combine(stream_.component, hash_name("bump"));
    Draws draws(stream, jolts_++);
    turn_rad += draws.normal() * bump.turn_rad;
  }
  return turn_rad;
}

}  // namespace ganglion::sim
