#pragma once

#include <string>

#include "ganglion/sim/world/world.h"

namespace ganglion::sim {

/// The drawing of a world as JSON, for the report's player and other viewers [m, rad]:
///   name
///   bounds    [min x, min y, max x, max y]
///   shapes    list of {class: "wall" | "furniture", kind: "wall" | "box" | "disc" | "polygon", points: [[x, y], ...]
///             and closed, or x, y, radius; material; id and label where given}
///   map       {origin: [x, y, yaw], resolution, columns, rows, occupied, unknown: lists of rectangles of cells
///             [column, row, columns, rows] counted from the lower left} where there is one
///   movers    list of {class: "mover", id, label, points in its own frame or radius, pose: [x, y, yaw] as it stands}
///   spawns    list of {id, label, pose}
///   floor     list of {id, label, points or x, y, radius; colour "#rrggbb", slip, uphill: [x, y] rise per metre}
///   bumps     list of [[x, y], [x, y]]
///   beacons   list of {id, label, x, y, light, sound: ranges, colour}
/// The last three are there only where the world has such things.
/// Lengths are rounded to 0.1 mm to keep it small.
std::string scene_json(const World& world);

}  // namespace ganglion::sim
