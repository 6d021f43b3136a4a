// What the module shows of itself: signals on its outputs, the plan, the map.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ganglion/acting/dynamic_map_router/dynamic_map_router.h"
#include "ganglion/base/hash.h"
#include "ganglion/math/functions.h"
#include "ganglion/units/angle.h"

namespace ganglion {
namespace {

using grid::Cell;
using grid::CellIndex;

/// Most columns and rows of the map that are shown at once, round the robot.
constexpr std::int32_t kShownCells = 1024;
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

struct Extent {
  CellIndex low{};
  CellIndex high{};  ///< Exclusive.
  int columns() const noexcept { return high.column - low.column; }
  int rows() const noexcept { return high.row - low.row; }
};

/// The ground of all tiles, cut to what is shown round the robot.
Extent extent_of(const grid::RiskMap& map, CellIndex robot) {
  Extent extent{{grid::kFarthestCell, grid::kFarthestCell}, {-grid::kFarthestCell, -grid::kFarthestCell}};
  for (const auto& tile : map.tiles()) {
    const CellIndex corner{tile->column * grid::kTileSide, tile->row * grid::kTileSide};
    extent.low = {std::min(extent.low.column, corner.column), std::min(extent.low.row, corner.row)};
    extent.high = {std::max(extent.high.column, corner.column + grid::kTileSide),
                   std::max(extent.high.row, corner.row + grid::kTileSide)};
  }
  const std::int32_t half = kShownCells / 2;
  extent.low = {std::max(extent.low.column, robot.column - half), std::max(extent.low.row, robot.row - half)};
  extent.high = {std::min(extent.high.column, robot.column + half), std::min(extent.high.row, robot.row + half)};
  return extent;
}

constexpr std::array<Class, 2> kLabels = {
    {{0.5F, Role::Free, {"empty cell", "celda vacía"}}, {1, Role::Solid, {"occupied cell", "celda ocupada"}}}};
constexpr std::array<Class, 2> kNatures = {
    {{0, Role::Moving, {"dynamic cell", "celda dinámica"}}, {1, Role::Plain, {"static cell", "celda estática"}}}};
constexpr std::array<Class, 2> kInhibitions = {
    {{0, Role::Free, {"not inhibited", "no inhibida"}}, {1, Role::Danger, {"inhibited cell", "celda inhibida"}}}};

Vector2 centre(CellIndex cell, double cell_m) noexcept {
  return {(cell.column + 0.5) * cell_m, (cell.row + 0.5) * cell_m};
}

/// What the layers of the map hold, cell by cell.
struct Values {
  std::vector<float> label, risk, is_static, inhibited;

  void add(const Cell* cell, std::uint32_t now) {
    const bool known = cell != nullptr && cell->label != grid::Label::Unexplored;
    const auto flag = [&](bool value) { return known ? (value ? 1.0f : 0.0f) : kUnknown; };
    label.push_back(!known ? kUnknown : cell->label == grid::Label::Occupied ? 1.0f : 0.5f);
    risk.push_back(known ? static_cast<float>(cell->risk) : kUnknown);
    is_static.push_back(flag(known && cell->nature == grid::Nature::Static));
    inhibited.push_back(flag(known && grid::RiskMap::inhibited(*cell, now)));
  }
};

}  // namespace

void DynamicMapRouter::publish(Phase phase, const Feedback& feedback) const noexcept {
  const auto left = plan();
  const grid::Cell* ahead = attempt_ ? map_.find(attempt_->to) : nullptr;
  double length = 0;
  if (!left.empty()) {
    for (const grid::RouteStep& step : router_.route().subspan(next_)) {
      length += grid::is_diagonal(step.direction) ? std::numbers::sqrt2 : 1;
    }
  }
  put(kRiskAhead, ahead != nullptr ? ahead->risk : 0);
  put(kRouteLength, length * config_.cell_m);
  put(kPhase, static_cast<double>(phase));
  put(kExplored, map_.explored());
  put(kOccupied, map_.occupied());
  put(kFailures, failures_);
  put(kRounds, rounds_);
  publish_goal(feedback);
}

void DynamicMapRouter::publish_goal(const Feedback& feedback) const noexcept {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const PortView& position = feedback[kPosition];
  const bool placed = goal_ && position.wired();
  const double x_m = placed ? (goal_->column + 0.5) * config_.cell_m - position.values[0] : kNone;
  const double y_m = placed ? (goal_->row + 0.5) * config_.cell_m - position.values[1] : kNone;
  const bool seen = std::isfinite(x_m) && std::isfinite(y_m);
  double bearing_rad = feedback.value(kGoalDirection);
  if (!std::isfinite(bearing_rad)) bearing_rad = seen ? math::atan2(y_m, x_m) : kNone;
  const double error_rad = wrap_rad(bearing_rad - feedback.value(kHeading));
  put(kGoalDistance, seen ? math::hypot(x_m, y_m) : kNone);
  put(kGoalError, std::isfinite(error_rad) ? error_rad : kNone);
}

std::span<const Command> DynamicMapRouter::plan() const noexcept {
  return std::span<const Command>(commands_).subspan(std::min(next_, commands_.size()));
}

void DynamicMapRouter::show(Exhibition& exhibition) const {
  if (!cell_ || map_.tiles().empty()) return;
  show_map(exhibition);
  show_route(exhibition);
  show_attempts(exhibition);
}

void DynamicMapRouter::show_map(Exhibition& exhibition) const {
  const Extent extent = extent_of(map_, *cell_);
  if (extent.columns() <= 0 || extent.rows() <= 0) return;
  std::uint64_t generation = combine(map_.revision(), static_cast<std::uint64_t>(map_.explored()));
  generation = combine(generation, map_.next_lapse(now_).value_or(0));
  for (const CellIndex corner : {extent.low, extent.high}) {
    generation = combine(generation, static_cast<std::uint64_t>(corner.column));
    generation = combine(generation, static_cast<std::uint64_t>(corner.row));
  }
  if (!exhibition.lacks("map", generation)) return;
  Values values;
  for (std::int32_t row = extent.low.row; row < extent.high.row; ++row) {
    for (std::int32_t column = extent.low.column; column < extent.high.column; ++column) {
      values.add(map_.find({column, row}), now_);
    }
  }
  const std::array<Layer, 4> layers = {
      {{.name = "label", .title = {"cells", "celdas"}, .scale = {.classes = kLabels}, .values = values.label},
       {.name = "risk", .title = {"risk", "riesgo"}, .values = values.risk},
       {.name = "static",
        .title = {"nature", "naturaleza"},
        .scale = {.classes = kNatures},
        .values = values.is_static},
       {.name = "inhibited",
        .title = {"inhibition", "inhibición"},
        .scale = {.classes = kInhibitions},
        .values = values.inhibited}}};
  const double cell_m = config_.cell_m;
  exhibition.field({.name = "map",
                    .title = {"Learned map", "Mapa aprendido"},
                    .origin = {extent.low.column * cell_m, extent.low.row * cell_m},
                    .cell = {cell_m, cell_m},
                    .columns = extent.columns(),
                    .rows = extent.rows(),
                    .layers = layers,
                    .generation = generation});
}

void DynamicMapRouter::show_route(Exhibition& exhibition) const {
  std::vector<Vector2> points;
  if (!plan().empty()) {
    points.push_back(centre(*cell_, config_.cell_m));
    for (const grid::RouteStep& step : router_.route().subspan(next_)) {
      points.push_back(centre(step.to, config_.cell_m));
    }
  }
  const std::array<Shape, 1> route = {Shape{.role = Role::Plan, .points = points}};
  const std::size_t shapes = points.empty() ? 0 : 1;
  exhibition.marks({.name = "route", .title = {"Route", "Ruta"}, .shapes = std::span(route).first(shapes)});
}

void DynamicMapRouter::show_attempts(Exhibition& exhibition) const {
  std::vector<std::array<Vector2, 2>> lines;
  const std::size_t count = std::min(attempts_, tried_.size());
  for (const Tried& one : std::span(tried_).first(count)) {
    lines.push_back({centre(one.from, config_.cell_m), centre(one.to, config_.cell_m)});
  }
  std::vector<Shape> shapes;
  for (const auto& line : lines) shapes.push_back({.role = Role::Tried, .points = line});
  exhibition.marks({.name = "attempts", .title = {"Failed attempts", "Intentos fallidos"}, .shapes = shapes});
}

}  // namespace ganglion
