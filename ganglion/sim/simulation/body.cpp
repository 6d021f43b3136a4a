#include "ganglion/sim/simulation/body.h"

#include <algorithm>
#include <cmath>

namespace ganglion::sim {
namespace {

constexpr double kTimeTolerance_s = 1e-9;   // pieces of a sub-step shorter than this are rounding
constexpr double kTouchTolerance_m = 1e-6;  // discs this close to each other touch
constexpr double kGraze_mps = 1e-3;         // slower approaches are no contacts to count
constexpr double kAlongNormal = 0.99;  // cosine between a contact's normal and the line from the robot that was hit

}  // namespace

Body::Body(const RobotModel& model, std::unique_ptr<Drive> drive)
    : model_(&model), drive_(std::move(drive)), ride_(model) {
  for (const CommandElement& element : model.description.commands.front().elements) safe_.push_back(element.safe);
  command_ = safe_;
}

void Body::make_room(std::size_t robots) {
  near_.reserve(robots);
  bumps_.reserve(robots);
}

void Body::reset(const Pose2& pose, const StreamId& chance) noexcept {
  truth_ = {};
  truth_.pose = truth_.start = pose;
  contacts_.clear();
  drive_->reset();
  ride_.reset(chance);
  sag(0);
  bumps_.clear();
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

void Body::advance(const World& world, std::span<const Disc> others, std::size_t self, double elapsed_s, double time_s,
                   double step_s) noexcept {
  bumps_.clear();
  const double left_s = ttl_s_ - elapsed_s;
  if (!lapsed_ && !(left_s > kTimeTolerance_s)) lapse(step_s);
  if (lapsed_ || left_s >= step_s - kTimeTolerance_s) {
    move(world, others, self, time_s, step_s);
    return;
  }
  move(world, others, self, time_s, left_s);
  lapse(step_s);
  move(world, others, self, time_s + left_s, step_s - left_s);
}

World::Slide Body::slide(const World& world, std::span<const Disc> others, std::size_t self,
                         Vector2 displacement) noexcept {
  near_.clear();
  const Vector2 from = truth_.pose.position;
  const double way_m = displacement.length();
  for (std::size_t i = 0; i < others.size(); ++i) {
    const double reach_m = way_m + others[i].radius_m + model_->radius_m + kTouchTolerance_m;
    if (i != self && (others[i].position - from).squared() <= reach_m * reach_m) near_.push_back(others[i]);
  }
  return world.slide(from, displacement, model_->radius_m, near_);
}

void Body::move(const World& world, std::span<const Disc> others, std::size_t self, double time_s,
                double step_s) noexcept {
  const Floor& floor = world.ground().plan().floor;
  Movement movement = drive_->move(truth_.pose, step_s);
  if (!floor.plain()) movement = ride_.over(floor, movement, truth_);
  World::Slide result{truth_.pose.position, truth_.touching, truth_.contact_normal};  // at rest nothing changes
  const bool moves = movement.displacement.squared() > 0;
  if (moves) result = slide(world, others, self, movement.displacement);
  const Vector2 gone = result.position - truth_.pose.position;
  if (!floor.bumps.empty()) movement.turn_rad += ride_.jolt_rad(floor, truth_.pose.position, result.position);

  truth_.velocity_mps = gone * (1 / step_s);
  truth_.turn_rate_radps = movement.turn_rad / step_s;
  truth_.pose.position = result.position;
  truth_.pose.yaw = (truth_.pose.yaw + Angle::from_rad(movement.turn_rad)).wrapped();
  truth_.left_m += movement.left_m;
  truth_.right_m += movement.right_m;
  const double gone_m = gone.length();
  truth_.travelled_m += gone_m;
  truth_.touching = result.touched;
  truth_.touched = truth_.touched || result.touched;
  const EnergyModel& energy = model_->energy;
  const double power_W = energy.idle_W + energy.drive_W * movement.effort;
  spend(power_W * step_s + energy.travel_J_per_m * gone_m);
  sag(power_W + energy.travel_J_per_m * gone_m / step_s);
  if (moves && result.touched) {
    const double speed_mps = std::max(0.0, -movement.displacement.dot(result.normal) / step_s);
    note_contact(result.normal, speed_mps, time_s);
    note_bumps(others, self, result.normal, speed_mps);
  }
  drive_->feel(moves && result.touched);
}

void Body::note_contact(Vector2 normal, double speed_mps, double time_s) noexcept {
  truth_.contact_normal = normal;
  if (!contacts_.begins(normal, time_s) || speed_mps < kGraze_mps) return;
  ++truth_.contacts;
  truth_.contact_speed_mps = std::max(truth_.contact_speed_mps, speed_mps);
  truth_.fastest_contact_mps = std::max(truth_.fastest_contact_mps, speed_mps);
  spend(model_->energy.contact_J);
}

void Body::note_bumps(std::span<const Disc> others, std::size_t self, Vector2 normal, double speed_mps) noexcept {
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (i == self) continue;
    const Vector2 apart = truth_.pose.position - others[i].position;
    const double apart_m = apart.length();
    if (apart_m > others[i].radius_m + model_->radius_m + kTouchTolerance_m) continue;
    if (apart.dot(normal) >= kAlongNormal * apart_m) bumps_.push_back({i, normal, speed_mps});
  }
}

void Body::bumped(Vector2 normal, double speed_mps, double time_s) noexcept {
  truth_.touching = truth_.touched = true;
  note_contact(normal, speed_mps, time_s);
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
