#include "ganglion/sim/world/plan/plan_points.h"

#include <algorithm>
#include <optional>

#include "ganglion/base/text.h"

namespace ganglion::sim {
namespace {

std::optional<double> number_of(const config::Value& value) noexcept {
  if (value.real() != nullptr) return *value.real();
  if (value.integer() != nullptr) return static_cast<double>(*value.integer());
  return std::nullopt;
}

std::string named(const config::Table& table) { return table.context().empty() ? "" : table.context() + ": "; }

std::optional<Vector2> read_point(const config::Value& item, const config::Table& table, std::string_view key) {
  const config::Array* pair = item.array();
  const auto x = pair != nullptr && pair->size() == 2 ? number_of(pair->front()) : std::nullopt;
  const auto y = pair != nullptr && pair->size() == 2 ? number_of(pair->back()) : std::nullopt;
  if (!x || !y) {
    table.problems().add(item.place(), ErrorCode::BadType,
                         {"{}each of {} must be a point [x, y] of two numbers",
                          "{}cada elemento de {} debe ser un punto [x, y] de dos números"},
                         named(table), key);
    return std::nullopt;
  }
  if (!(std::fabs(*x) <= kMaxCoordinate_m && std::fabs(*y) <= kMaxCoordinate_m)) {
    table.problems().add(item.place(), ErrorCode::BadParameter,
                         {"{}the point ({}, {}) lies beyond {} m", "{}el punto ({}, {}) está más allá de {} m"},
                         named(table), shortest(*x), shortest(*y), kMaxCoordinate_m);
    return std::nullopt;
  }
  return Vector2{*x, *y};
}

/// 1 if c lies left of a->b, -1 if right, 0 if on the line.
int side_of(Vector2 a, Vector2 b, Vector2 c) noexcept {
  const double cross = (b - a).cross(c - a);
  return cross > 0 ? 1 : (cross < 0 ? -1 : 0);
}

bool within_box(Vector2 a, Vector2 b, Vector2 c) noexcept {
  Box2 box{a, a};
  box.include(b);
  return box.contains(c);
}

bool edges_meet(Vector2 a, Vector2 b, Vector2 c, Vector2 d) noexcept {
  const int c_side = side_of(a, b, c), d_side = side_of(a, b, d), a_side = side_of(c, d, a), b_side = side_of(c, d, b);
  if (c_side * d_side < 0 && a_side * b_side < 0) return true;
  return (c_side == 0 && within_box(a, b, c)) || (d_side == 0 && within_box(a, b, d)) ||
         (a_side == 0 && within_box(c, d, a)) || (b_side == 0 && within_box(c, d, b));
}

}  // namespace

Vector2 read_position(config::Table& table) {
  const double x = table.number("x_m", kCoordinate);
  return {x, table.number("y_m", kCoordinate)};
}

std::vector<Vector2> read_points(config::Table& table, std::string_view key, std::size_t least) {
  table.asks(key, {.form = config::Asked::Form::Points,
                   .required = true,
                   .range = {-kMaxCoordinate_m, kMaxCoordinate_m},
                   .least = least});
  const config::Value* found = table.value(key);
  if (found == nullptr) {
    table.problem(key, ErrorCode::MissingKey,
                  {"{} is missing: write {} = [[x, y], ...]", "falta {}: escriba {} = [[x, y], ...]"}, key, key);
    return {};
  }
  if (found->array() == nullptr || found->array()->size() < least) {
    table.problem(key, found->array() == nullptr ? ErrorCode::BadType : ErrorCode::BadParameter,
                  {"{} must be a list of at least {} point{} [[x, y], ...]",
                   "{} debe ser una lista de al menos {} punto{} [[x, y], ...]"},
                  key, least, least == 1 ? "" : "s");
    return {};
  }
  std::vector<Vector2> points;
  for (const config::Value& item : *found->array()) {
    if (const auto point = read_point(item, table, key)) points.push_back(*point);
  }
  return points.size() == found->array()->size() ? points : std::vector<Vector2>{};
}

bool check_spacing(config::Table& table, std::string_view key, const std::vector<Vector2>& points, bool closed) {
  const std::size_t count = points.size();
  bool apart = count > 0;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
    const Vector2 a = points[i], b = points[(i + 1) % count];
    if ((b - a).length() >= kMinSize_m) continue;
    apart = false;
    const config::Array& items = *table.value(key)->array();
    table.problems().add(items[(i + 1) % count].place(), ErrorCode::BadParameter,
                         {"{}points {} and {} of {} are the same (closer than {} m){}",
                          "{}los puntos {} y {} de {} son el mismo (a menos de {} m){}"},
                         named(table), i, (i + 1) % count, key, kMinSize_m,
                         i + 1 == count
                             ? Text{"; the last joins the first by itself", "; el último se une al primero por sí solo"}
                             : Text{"", ""});
  }
  return apart;
}

void check_outline(config::Table& table, std::string_view key, const std::vector<Vector2>& points) {
  const std::size_t count = points.size();
  if (count > kMaxPolygonPoints) {
    table.problem(key, ErrorCode::TooLarge,
                  {"a polygon may have {} points, this one has {}; split it",
                   "un polígono puede tener {} puntos, este tiene {}; divídalo"},
                  kMaxPolygonPoints, count);
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 2; j < count; ++j) {
      if (i == 0 && j + 1 == count) continue;  // neighbours
      if (!edges_meet(points[i], points[i + 1], points[j], points[(j + 1) % count])) continue;
      table.problem(key, ErrorCode::BadParameter,
                    {"the polygon's outline crosses or touches itself: edges {}-{} and {}-{}",
                     "el contorno del polígono se cruza o se toca a sí mismo: lados {}-{} y {}-{}"},
                    i, i + 1, j, (j + 1) % count);
      return;
    }
  }
  if (std::fabs(doubled_area(points)) < 2 * kMinSize_m * kMinSize_m) {
    table.problem(key, ErrorCode::BadParameter,
                  {"the polygon has no area: its points lie on one line",
                   "el polígono no tiene área: sus puntos están en una línea"});
  }
}

}  // namespace ganglion::sim
