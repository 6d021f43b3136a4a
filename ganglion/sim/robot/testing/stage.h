#pragma once

#include <gtest/gtest.h>

#include "ganglion/sim/robot/robot_model.h"

namespace ganglion::sim::testing {

/// The ground of a world file's text; the test fails where it has problems.
inline std::shared_ptr<const Ground> ground_of(std::string_view text) {
  Problems problems;
  auto ground = Ground::parse(text, "world.toml", problems);
  EXPECT_TRUE(ground && problems.empty()) << problems.text();
  return ground ? std::make_shared<const Ground>(std::move(*ground)) : nullptr;
}

/// A device of a kind, the parameters that are given changed.
template <class Product>
std::unique_ptr<Product> made(const Kind<Product>& kind,
                              std::initializer_list<std::pair<std::string_view, double>> changed = {}) {
  Parameters parameters(kind.descriptor.parameters);
  for (const auto& [name, value] : changed) parameters.set(name, value);
  auto product = kind.make(parameters);
  EXPECT_TRUE(product) << product.error().what.en;
  return std::move(*product);
}

/// Nothing within 90 m.
inline constexpr std::string_view kOpenGround = "format = 1\nname = \"w\"\n[[wall]]\npoints = [[90, -9], [90, 9]]\n";

/// At the origin.
inline Pose2 turned(double yaw_deg) { return {{0, 0}, Angle::from_deg(yaw_deg)}; }

/// One robot on a ground, with what a sensor at its centre sees.
struct Stage {
  explicit Stage(std::string_view world_text = kOpenGround) : world(ground_of(world_text)) {}
  /// The scene of a sensor at that pose.
  Scene at(const Pose2& pose, double time_s = 0) {
    robot.pose = pose;
    return {.world = world,
            .robot = robot,
            .heading = direction(pose.yaw.rad()),
            .others = others,
            .radius_m = 0.1,
            .time_s = time_s};
  }
  World world;
  Truth robot;
  std::vector<Disc> others;
};

/// Runs a drive on open ground for `count` sub-steps.
inline Pose2 driven(Drive& drive, Pose2 pose, double step_s, int count) {
  for (int n = 0; n < count; ++n) {
    const Movement movement = drive.move(pose, step_s);
    pose.position += movement.displacement;
    pose.yaw = (pose.yaw + Angle::from_rad(movement.turn_rad)).wrapped();
    drive.feel(false);
  }
  return pose;
}

}  // namespace ganglion::sim::testing
