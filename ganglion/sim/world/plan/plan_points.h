#pragma once

#include <string_view>
#include <vector>

#include "ganglion/config/table.h"
#include "ganglion/sim/world/plan/plan.h"

namespace ganglion::sim {

/// What a place and an extent may be, in metres.
constexpr config::Range kCoordinate{-kMaxCoordinate_m, kMaxCoordinate_m};
constexpr config::Range kExtent{kMinSize_m, 2 * kMaxCoordinate_m};

/// Reads the keys x_m and y_m.
Vector2 read_position(config::Table& table);

/// Reads `key = [[x, y], ...]`, at least `least` points within the coordinate limit. On any problem, which is reported
/// at its place, gives none.
std::vector<Vector2> read_points(config::Table& table, std::string_view key, std::size_t least);

/// Reports neighbours (with `closed`, also last and first) that lie closer than kMinSize_m. False if any do, or if
/// there are no points.
bool check_spacing(config::Table& table, std::string_view key, const std::vector<Vector2>& points, bool closed);

/// Reports an outline with too many points, no area, or edges that cross or touch.
void check_outline(config::Table& table, std::string_view key, const std::vector<Vector2>& points);

}  // namespace ganglion::sim
