#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/config/outline.h"
#include "ganglion/config/value.h"
#include "ganglion/geometry/pose2.h"
#include "ganglion/sim/world/map/occupancy_map.h"
#include "ganglion/sim/world/shape/beacon.h"
#include "ganglion/sim/world/shape/limits.h"
#include "ganglion/sim/world/shape/shape.h"

namespace ganglion::sim {

/// Walks as people do: straight to a goal drawn from an area, a pause, the next goal. Ours.
struct Stroll {
  Box2 area;  ///< Of the goals.
  Vector2 start;
  double pause_min_s = 0;
  double pause_max_s = 0;
  bool avoids_robots =
      false;  ///< Turns to another goal before it meets a robot; otherwise it goes on until it would touch.
};

/// A solid that changes its place while robots drive; it keeps clear of them, and of walls only if it strolls.
struct MoverPlan {
  std::string id;
  std::string label;
  Material material = Material::Rough;
  std::vector<Vector2> outline;  ///< A rectangle in its own frame, counter-clockwise; empty for a disc.
  double radius_m = 0;           ///< Of the disc, or of the circle round the outline.
  /// Either places: at random moments it jumps to another one that is free...
  std::vector<Pose2> places;
  double change_min_s = 0;
  double change_max_s = 0;
  /// ...or a path it follows without turning; it waits while a robot stands in its way.
  std::vector<Vector2> path;
  Angle yaw;  ///< While on the path or strolling.
  double speed_mps = 0;
  bool loop = false;             ///< From the last point straight to the first and on; otherwise it stops at the last.
  std::optional<Stroll> stroll;  ///< ...or neither: it strolls.
  Place place;                   ///< Where it is written.
};

/// A named place to start from.
struct Spawn {
  std::string id;
  std::string label;
  Pose2 pose;
  Place place;  ///< Where it is written.
};

/// What a world file says, checked item by item, before it is made ready for queries.
struct GroundPlan {
  std::string name;
  Material material = Material::Rough;  ///< Of the map, and of every shape that names none.
  std::vector<Shape> shapes;
  Floor floor;
  std::vector<Beacon> beacons;
  std::vector<MoverPlan> movers;
  std::vector<Spawn> spawns;
  std::optional<OccupancyMap> map;
  std::optional<Box2> area;  ///< The ground that counts, for worlds that no wall encloses.
  Place place;
};

/// Reads `world.toml`, or a ROS map `.yaml` as a world of its own. Everything wrong with it goes into `problems`.
GroundPlan load_plan(FileReader& files, int file, std::span<const config::Override> overrides, Problems& problems);
/// The same from a text, without its map. `outline` takes down what was asked.
GroundPlan parse_plan(std::string_view text, const std::string& file_name, Problems& problems,
                      config::Outline* outline = nullptr);

}  // namespace ganglion::sim
