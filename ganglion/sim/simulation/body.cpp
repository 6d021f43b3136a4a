#include "ganglion/sim/simulation/body.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ganglion::sim {
namespace {

constexpr double kSliver_s = 1e-9;    // pieces of a sub-step shorter than this are rounding
constexpr double kClear_m = 1e-6;     // left over where nothing is met
constexpr double kLookAhead_m = 0.5;  // beyond a step's way when the ground is looked at: for the next steps
constexpr double kRounding_m = 1e-12;
constexpr double kGraze_mps = 1e-3;  // slower approaches are no contacts to count

/// Two movements of which the first took that share of the time.
Movement one_after_the_other(const Movement& first, const Movement& second, double share) noexcept {
  return {.displacement = first.displacement + second.displacement,
          .turn_rad = first.turn_rad + second.turn_rad,
          .left_m = first.left_m + second.left_m,
          .right_m = first.right_m + second.right_m,
          .effort = first.effort * share + second.effort * (1 - share),
          .path_m = first.path_m + second.path_m};
}

}  // namespace

Body::Body(const RobotModel& model, std::unique_ptr<Drive> drive)
    : model_(&model), drive_(std::move(drive)), ride_(model) {
  for (const CommandElement& element : model.description.commands.front().elements) safe_.push_back(element.safe);
  command_ = safe_;
}

void Body::reset(const Pose2& pose, const StreamId& chance) noexcept {
  truth_ = {};
  truth_.pose = truth_.start = {pose.position, pose.yaw.wrapped()};
  ahead_ = direction(truth_.pose.yaw.rad());
  contacts_.clear();
  leaning_ = false;
  room_m_ = 0;
  drive_->reset();
  ride_.reset(chance);
  sag(0);
}

void Body::begin(const ActFrame& frame, double step_s) noexcept {
  const auto& elements = model_->description.commands.front().elements;
  for (std::size_t n = 0; n < elements.size(); ++n) {
    const double wanted = frame.values[n];
    command_[n] = std::isfinite(wanted) ? std::clamp(wanted, elements[n].min, elements[n].max) : elements[n].safe;
  }
  ttl_s_ = frame.ttl_s[0];
  lapsed_ = false;
  truth_.touched = truth_.touching;
  ride_.begin();
  truth_.contact_speed_mps = 0;
  truth_.step_energy_J = 0;
  drive_->command(command_, truth_.pose, step_s, true);
}

void Body::lapse(double step_s) noexcept {
  lapsed_ = true;
  drive_->command(safe_, truth_.pose, step_s, false);
}

double Body::steady_way_m(double step_s) const noexcept {
  // A battery changes the speed with every sub-step.
  if (model_->battery.present() || ttl_s_ < step_s - kSliver_s) return std::numeric_limits<double>::infinity();
  return drive_->steady_mps() * step_s;
}

Body::Way Body::way(double way_m, double step_s) const noexcept {
  const Movement movement = drive_->foreseen(truth_.pose, step_s);
  const double turn_rad = std::fabs(movement.turn_rad);
  return {movement.displacement, turn_rad < kPi / 2 ? way_m * turn_rad / 4 : way_m};
}

bool Body::off_ground(const Ground& ground, double way_m, double step_s) noexcept {
  if (room_m_ > way_m + kClear_m) return true;
  if (!std::isfinite(way_m)) return false;
  const Vector2 here = truth_.pose.position;
  room_m_ = ground.clearance(here, model_->radius_m + way_m + kLookAhead_m) - model_->radius_m;
  if (room_m_ > way_m + kClear_m) return true;
  const Way way = this->way(way_m, step_s);
  Contact first;
  ground.sweep(here, way.chord, model_->radius_m + way.bulge_m + kClear_m, first);
  return !first.happened();
}

double Body::nearest_m(Vector2 point, double way_m, double step_s) const noexcept {
  const Way way = this->way(way_m, step_s);
  const Vector2 here = truth_.pose.position;
  return (point - nearest_on_segment(point, here, here + way.chord)).length() - way.bulge_m;
}

void Body::advance_freely(double step_s) noexcept {
  const Movement movement = drive_->move(truth_.pose, step_s);
  const bool moves = movement.displacement.squared() > 0;
  if (moves) truth_.touching = false;
  go(movement, truth_.pose.position + movement.displacement, movement.path_m, step_s);
  drive_->feel(false);
}

void Body::intend(const Floor& floor, double elapsed_s, double step_s) noexcept {
  const double left_s = ttl_s_ - elapsed_s;
  if (!lapsed_ && !(left_s > kSliver_s)) lapse(step_s);
  if (lapsed_ || left_s >= step_s - kSliver_s) {
    intent_ = drive_->move(truth_.pose, step_s);
  } else {
    const Movement first = drive_->move(truth_.pose, left_s);
    const Pose2 between{truth_.pose.position + first.displacement, truth_.pose.yaw + Angle::from_rad(first.turn_rad)};
    lapse(step_s);
    intent_ = one_after_the_other(first, drive_->move(between, step_s - left_s), left_s / step_s);
  }
  if (!floor.plain()) intent_ = ride_.over(floor, intent_, truth_);
}

void Body::stand_alone() noexcept {
  if (leaning_) truth_.touching = leaning_ = false;
}

void Body::settle(const Floor& floor, Vector2 to, bool pressed, double step_s) noexcept {
  const bool wants = intent_.displacement.squared() > 0;
  if (!floor.bumps.empty()) intent_.turn_rad += ride_.jolt_rad(floor, truth_.pose.position, to);
  if (wants || pressed || !(to == truth_.pose.position)) {  // at rest nothing changes
    truth_.touching = pressed;
    leaning_ = false;
  }
  truth_.touched = truth_.touched || truth_.touching;
  go(intent_, to, (to - truth_.pose.position).length(), step_s);
  drive_->feel(wants && pressed);
}

void Body::go(const Movement& movement, Vector2 to, double path_m, double step_s) noexcept {
  const Vector2 gone = to - truth_.pose.position;
  truth_.velocity_mps = gone * (1 / step_s);
  truth_.turn_rate_radps = movement.turn_rad / step_s;
  truth_.pose.position = to;
  if (movement.turn_rad != 0) {
    truth_.pose.yaw = (truth_.pose.yaw + Angle::from_rad(movement.turn_rad)).wrapped();
    ahead_ = direction(truth_.pose.yaw.rad());
  }
  truth_.left_m += movement.left_m;
  truth_.right_m += movement.right_m;
  truth_.travelled_m += path_m;
  room_m_ -= gone.length() + kRounding_m;
  const EnergyModel& energy = model_->energy;
  const double power_W = energy.idle_W + energy.drive_W * movement.effort;
  spend(power_W * step_s + energy.travel_J_per_m * path_m);
  sag(power_W + energy.travel_J_per_m * path_m / step_s);
}

void Body::note_contact(Vector2 normal, double speed_mps, double time_s) noexcept {
  truth_.contact_normal = normal;
  if (!contacts_.begins(normal, time_s) || speed_mps < kGraze_mps) return;
  ++truth_.contacts;
  truth_.contact_speed_mps = std::max(truth_.contact_speed_mps, speed_mps);
  truth_.fastest_contact_mps = std::max(truth_.fastest_contact_mps, speed_mps);
  spend(model_->energy.contact_J);
}

void Body::spend(double energy_J) noexcept {
  truth_.energy_J += energy_J;
  truth_.step_energy_J += energy_J;
}

void Body::sag(double power_W) noexcept {
  const BatteryModel& battery = model_->battery;
  if (!battery.present()) return;
  truth_.charge = std::max(battery.charge - truth_.energy_J / battery.capacity_J, 0.0);
  truth_.battery_V = battery.voltage_V(truth_.charge, power_W);
  drive_->supply(std::min(truth_.battery_V / battery.full_V, 1.0));
}

}  // namespace ganglion::sim
