#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "ganglion/base/text.h"
#include "ganglion/random/draws.h"
#include "ganglion/sim/world/world.h"

namespace ganglion::sim {

/// The ground that a world file with this text describes.
inline std::shared_ptr<const Ground> ground_of(const std::string& text) {
  Problems problems;
  auto ground = Ground::parse("format = 1\n" + text, "test.toml", problems);
  EXPECT_TRUE(ground) << problems.text();
  return ground ? std::make_shared<const Ground>(std::move(*ground)) : nullptr;
}
inline World world_of(const std::string& text) { return World(ground_of(text)); }

/// The folder of public data that some tests compare with; empty where it is absent.
inline std::filesystem::path data_folder() {
  const char* given = std::getenv("GANGLION_DATA");
  const std::filesystem::path folder =
      given != nullptr ? std::filesystem::path(given) : std::filesystem::path(GANGLION_SOURCE_DIR) / "../shared/data";
  return std::filesystem::exists(folder) ? folder : std::filesystem::path();
}

/// A plan of random walls, boxes, discs and triangles in a square of 20 m, closed by a wall if `closed`.
inline GroundPlan random_plan(std::uint64_t seed, int things, bool closed) {
  Draws draws({seed, 0, 0, 7}, 0);
  auto somewhere = [&] {
    const double x = draws.uniform(0, 20);
    return Vector2{x, draws.uniform(0, 20)};
  };
  GroundPlan plan;
  if (closed) plan.shapes.push_back({.closed = true, .points = {{0, 0}, {20, 0}, {20, 20}, {0, 20}}});
  for (int i = 0; i < things; ++i) {
    Shape shape;
    shape.kind = static_cast<ShapeKind>(i % 4);
    shape.structural = i % 3 == 0;
    shape.material = static_cast<Material>(i % 3);
    const Vector2 at = somewhere();
    if (shape.kind == ShapeKind::Wall) shape.points = {at, at + (somewhere() - at) * 0.3};
    if (shape.kind == ShapeKind::Box) {
      const double length = draws.uniform(0.1, 2), width = draws.uniform(0.1, 2);
      shape.points = rectangle(at, length, width, draws.uniform(-3, 3));
    }
    if (shape.kind == ShapeKind::Disc) shape.disc = {at, draws.uniform(0.05, 1)};
    if (shape.kind == ShapeKind::Polygon) {
      shape.points = {at, at + Vector2{draws.uniform(0.2, 1), 0}, at + Vector2{0.1, draws.uniform(0.2, 1)}};
    }
    plan.shapes.push_back(std::move(shape));
  }
  return plan;
}

inline World random_world(std::uint64_t seed, int things, bool closed) {
  Problems problems;
  auto ground = Ground::make(random_plan(seed, things, closed), problems);
  EXPECT_TRUE(ground) << problems.text();
  return World(std::make_shared<const Ground>(std::move(*ground)));
}

}  // namespace ganglion::sim
