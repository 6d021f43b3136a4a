#include "bench/support/sb12.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "ganglion/sim/drive/differential/differential.h"
#include "ganglion/sim/sensor/compass/compass.h"
#include "ganglion/sim/sensor/encoders/encoders.h"
#include "ganglion/sim/sensor/range/range.h"
#include "ganglion/sim/sensor/sonar/sonar.h"

namespace ganglion::bench {
namespace {

constexpr int kSensors = 12;
constexpr double kRadius_m = 0.15;
constexpr std::array kDrives = {&sim::differential_kind};
constexpr std::array<const sim::SensorKind*, 4> kKinds = {&sim::compass_kind, &sim::encoders_kind, &sim::range_kind,
                                                          &sim::sonar_kind};

/// A 64-bit linear congruential generator: what defines the layout, for any simulator in any language.
class Lcg {
 public:
  double uniform() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) * 0x1.0p-53;
  }

 private:
  std::uint64_t state_ = 12345;
};

[[noreturn]] void stop(const std::string& why) {
  std::fputs((why + "\n").c_str(), stderr);
  std::exit(1);
}

std::string sensor_text(int n, Eyes eyes) {
  const double yaw_rad = n * kPi / 6;
  std::string text = fmt::format("[[sensor]]\nid = \"s{}\"\nkind = \"{}\"\nx_m = {}\ny_m = {}\nyaw_deg = {}\n", n,
                                 eyes == Eyes::IdealRays ? "Range" : "Sonar", kRadius_m * std::cos(yaw_rad),
                                 kRadius_m * std::sin(yaw_rad), 30 * n);
  if (eyes == Eyes::IdealRays) return text;
  return text + fmt::format("rays = 5\nmirror_bounces = 1\nmax_range_m = {}\n", eyes == Eyes::Sonar3m ? 3 : 6);
}

std::string robot_text(Eyes eyes) {
  std::string text = fmt::format(
      "format = 1\nname = \"sb12\"\n[body]\nlength_m = 0.3\nwidth_m = 0.3\nradius_m = {}\n"
      "[drive]\nkind = \"Differential\"\nfull_scale_mps = 0.3\ntrack_m = 0.26\n",
      kRadius_m);
  for (int n = 0; n < kSensors; ++n) text += sensor_text(n, eyes);
  if (eyes == Eyes::IdealRays) return text;
  return text +
         "[[sensor]]\nid = \"wheels\"\nkind = \"Encoders\"\nresolution_m = 0.001\n"
         "[[sensor]]\nid = \"compass\"\nkind = \"Compass\"\nnoise_deg = 3\nresolution_deg = 0.1\n";
}

}  // namespace

Sb12Scene sb12_scene(int robots) {
  Lcg draw;
  Sb12Scene scene;
  scene.side_m = std::max(8.0, 2 * std::sqrt(robots));
  const int boxes = static_cast<int>(scene.side_m * scene.side_m / 8);
  const int across = static_cast<int>(std::ceil(std::sqrt(boxes + robots))) + 1;
  const double cell_m = scene.side_m / across;
  std::vector<Vector2> middles;
  for (int row = 0; row < across; ++row) {
    for (int column = 0; column < across; ++column) middles.push_back({(column + 0.5) * cell_m, (row + 0.5) * cell_m});
  }
  for (std::size_t k = middles.size() - 1; k > 0; --k) {
    std::swap(middles[k], middles[static_cast<std::size_t>(draw.uniform() * static_cast<double>(k + 1))]);
  }
  const double jitter_m = std::max(0.0, cell_m / 2 - 0.36 - 0.05);  // 0.36: half a box's diagonal
  for (int k = 0; k < boxes; ++k) {
    const double x = (draw.uniform() - 0.5) * jitter_m, y = (draw.uniform() - 0.5) * jitter_m;
    scene.boxes.push_back({middles[static_cast<std::size_t>(k)] + Vector2{x, y}, draw.uniform() * kPi});
  }
  for (int k = 0; k < robots; ++k) {
    const double yaw_rad = (draw.uniform() * 2 - 1) * kPi;
    scene.robots.push_back({middles[static_cast<std::size_t>(boxes + k)], Angle::from_rad(yaw_rad)});
  }
  return scene;
}

std::string sb12_text(const Sb12Scene& scene) {
  std::string text = fmt::format("arena {:.6f}\n", scene.side_m);
  for (const auto& box : scene.boxes) {
    text += fmt::format("box {:.6f} {:.6f} 0.5 0.5 {:.6f}\n", box.centre.x, box.centre.y, box.yaw_rad);
  }
  for (const Pose2& pose : scene.robots) {
    text += fmt::format("robot {:.6f} {:.6f} {:.6f}\n", pose.position.x, pose.position.y, pose.yaw.rad());
  }
  return text;
}

std::shared_ptr<const sim::Ground> sb12_ground(const Sb12Scene& scene) {
  sim::GroundPlan plan;
  const double side = scene.side_m;
  plan.shapes.push_back(
      {.material = sim::Material::Smooth, .closed = true, .points = {{0, 0}, {side, 0}, {side, side}, {0, side}}});
  for (const Sb12Scene::Box& box : scene.boxes) {
    plan.shapes.push_back({.kind = sim::ShapeKind::Box,
                           .material = sim::Material::Smooth,
                           .points = sim::rectangle(box.centre, 0.5, 0.5, box.yaw_rad)});
  }
  Problems problems;
  auto ground = sim::Ground::make(std::move(plan), problems);
  if (!ground) stop(problems.text());
  return std::make_shared<const sim::Ground>(std::move(*ground));
}

std::shared_ptr<const sim::RobotModel> sb12_robot(Eyes eyes) {
  Problems problems;
  auto model = sim::parse_robot(robot_text(eyes), "sb12.toml", {kDrives, kKinds}, problems);
  if (!model) stop(problems.text());
  return model;
}

Sb12Run::Sb12Run(sim::SimulationConfig config) {
  auto made = sim::Simulation::make(std::move(config));
  if (!made) stop(made.error().what.en);
  simulation_ = std::move(*made);
  const auto robots = static_cast<std::size_t>(simulation_->robots());
  turning_.resize(robots);
  senses_.assign(robots, make_sense_frame(simulation_->description()));
  acts_.assign(robots, make_act_frame(simulation_->description()));
  for (ActFrame& act : acts_) act.ttl_s.assign(act.ttl_s.size(), 1);
  stride_ = simulation_->description().sensations[1].name == "s0.echo_time" ? 2 : 1;
}

void Sb12Run::reset(std::uint64_t seed, std::uint32_t episode) {
  if (auto ready = simulation_->reset(seed, episode); !ready) stop(ready.error().what.en);
  std::fill(turning_.begin(), turning_.end(), 0);
  simulation_->sense(senses_);
}

double Sb12Run::range_m(int robot, int sensor, double reach_m) const {
  return std::min(senses_[static_cast<std::size_t>(robot)].values[static_cast<std::size_t>(sensor) * stride_], reach_m);
}

void Sb12Run::step() {
  for (std::size_t i = 0; i < acts_.size(); ++i) {
    const auto& values = senses_[i].values;
    const double front_m = std::min({values[0], values[stride_], values[11 * stride_]});
    int& turning = turning_[i];
    if (turning == 0 && front_m < 0.5) {
      turning = values[2 * stride_] > values[10 * stride_] ? 1 : -1;
    } else if (turning != 0 && front_m > 0.7) {
      turning = 0;
    }
    acts_[i].values[0] = turning == 0 ? 1 : -2.0 / 3 * turning;
    acts_[i].values[1] = turning == 0 ? 1 : 2.0 / 3 * turning;
  }
  simulation_->step(acts_, 0.1);
  simulation_->sense(senses_);
}

}  // namespace ganglion::bench
