#include "ganglion/plot/picture/ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace ganglion::plot {
namespace {

constexpr std::size_t kMaxOtherPlaces = 12;
const Colour kFloor = Colour::hex(0xeef1f4);
const Colour kMoverFill = Colour::hex(0x9aa2ab);
const Pen kWall{Colour::hex(0x22272e), 2.5, {}};
const Pen kFurnitureEdge{Colour::hex(0x4b535d), 1.2, {}};
const Pen kMoverEdge{Colour::hex(0x4b535d), 1.2, {}};
const Colour kZoneFill = Colour::hex(0xdbe6ee);
const Pen kZoneEdge{Colour::hex(0x6d8294), 1, {1, 3, 1, 3}};
const Pen kBump{Colour::hex(0x8a6d3b), 1.6, {8, 3, 2, 3}};
const Colour kBeaconFill = Colour::hex(0xffd54a);
const Pen kBeaconEdge{Colour::hex(0x22272e), 1.2, {}};
const Pen kOtherPlace{Colour::hex(0x7b838d), 1, {3, 3, 3, 3}};

std::vector<Vector2> placed(const Axes& axes, const std::vector<Vector2>& points, const Pose2& pose) {
  std::vector<Vector2> result;
  for (const Vector2 p : points) result.push_back(axes.at(pose.to_outer(p)));
  return result;
}

void draw_outline(Canvas& canvas, const Axes& axes, const Outline& outline, const Pen& pen) {
  std::vector<Vector2> points = placed(axes, outline.points, {});
  if (outline.closed && !points.empty()) points.push_back(points.front());
  canvas.line(points, pen);
}

void draw_filled(Canvas& canvas, const Axes& axes, const std::vector<Outline>& outlines, Colour fill) {
  std::vector<std::vector<Vector2>> shapes;
  for (const Outline& outline : outlines) shapes.push_back(placed(axes, outline.points, {}));
  canvas.polygons(shapes, fill);
}

/// A scanned map has too many blocks for a path each: it goes in as an image of its cells.
void draw_map(Canvas& canvas, const Axes& axes, const ScannedMap& map) {
  CellImage image(map.columns, map.rows);
  for (const ScannedMap::Block& block : map.unknown)
    image.fill(block.column, block.row, block.columns, block.rows, kMoverFill);
  for (const ScannedMap::Block& block : map.occupied)
    image.fill(block.column, block.row, block.columns, block.rows, kWall.colour);
  const Vector2 lower = axes.at(map.origin.position);
  const Vector2 right = axes.at(map.origin.to_outer({map.columns * map.cell_m, 0}));
  const Vector2 upper = axes.at(map.origin.to_outer({0, map.rows * map.cell_m}));
  canvas.image(image, lower, right - lower, upper - lower);
}

void draw_mover(Canvas& canvas, const Axes& axes, const Mover& mover, double time_s) {
  const std::size_t now = index_at(mover.times_s, time_s).value_or(0);
  std::vector<Pose2> others;
  for (std::size_t i = 0; i < mover.poses.size() && others.size() < kMaxOtherPlaces; ++i)
    if (!(mover.poses[i] == mover.poses[now]) && std::ranges::find(others, mover.poses[i]) == others.end())
      others.push_back(mover.poses[i]);
  for (const Pose2& pose : others) {
    std::vector<Vector2> points = placed(axes, mover.outline, pose);
    if (!points.empty()) points.push_back(points.front());
    canvas.line(points, kOtherPlace);
  }
  if (now < mover.poses.size()) canvas.polygon(placed(axes, mover.outline, mover.poses[now]), kMoverFill, kMoverEdge);
}

void draw_beacon(Canvas& canvas, Vector2 centre) {
  constexpr double kHalf_px = 7;
  const std::array<Vector2, 4> corners = {centre + Vector2{kHalf_px, 0}, centre + Vector2{0, kHalf_px},
                                          centre - Vector2{kHalf_px, 0}, centre - Vector2{0, kHalf_px}};
  canvas.polygon(corners, kBeaconFill, kBeaconEdge);
}

void add_floor_to_legend(Legend& legend, const Scene& scene, const Words& words) {
  const Vector2 half{7, 6};
  if (!scene.zones.empty())
    legend.add(std::string(words.floor_zone), [half](Canvas& canvas, Vector2 centre) {
      canvas.rectangle(centre - half, 2 * half, kZoneFill);
      canvas.rectangle(centre - half, 2 * half, kZoneEdge);
    });
  if (!scene.bumps.empty()) legend.add_line(std::string(words.bump), kBump);
  if (!scene.beacons.empty()) legend.add(std::string(words.beacon), draw_beacon);
}

}  // namespace

void draw_ground(Canvas& canvas, const Axes& axes, const Scene& scene, double time_s) {
  canvas.rectangle(axes.corner_px, axes.size_px, kFloor);
  canvas.clip(axes.corner_px, axes.size_px);
  for (const Outline& zone : scene.zones) canvas.polygon(placed(axes, zone.points, {}), kZoneFill, kZoneEdge);
  for (const Outline& bump : scene.bumps) draw_outline(canvas, axes, bump, kBump);
  for (const Outline& piece : scene.furniture) {
    if (piece.closed)
      canvas.polygon(placed(axes, piece.points, {}), Colour::hex(0xffffff), kFurnitureEdge);
    else
      draw_outline(canvas, axes, piece, kFurnitureEdge);
  }
  if (scene.map) draw_map(canvas, axes, *scene.map);
  draw_filled(canvas, axes, scene.solids, kWall.colour);
  for (const Outline& wall : scene.walls) draw_outline(canvas, axes, wall, kWall);
  for (const Mover& mover : scene.movers) draw_mover(canvas, axes, mover, time_s);
  for (const Vector2 beacon : scene.beacons) draw_beacon(canvas, axes.at(beacon));
  canvas.unclip();
}

void add_ground_to_legend(Legend& legend, const Scene& scene, const Words& words) {
  const Vector2 half{7, 6};
  if (!scene.walls.empty() || !scene.solids.empty() || scene.map) legend.add_line(std::string(words.wall), kWall);
  if (!scene.furniture.empty())
    legend.add(std::string(words.static_obstacle), [half](Canvas& canvas, Vector2 centre) {
      canvas.rectangle(centre - half, 2 * half, Colour::hex(0xffffff));
      canvas.rectangle(centre - half, 2 * half, kFurnitureEdge);
    });
  if (scene.map && !scene.map->unknown.empty())
    legend.add(std::string(words.unknown_ground),
               [half](Canvas& canvas, Vector2 centre) { canvas.rectangle(centre - half, 2 * half, kMoverFill); });
  add_floor_to_legend(legend, scene, words);
  if (scene.movers.empty()) return;
  legend.add(std::string(words.dynamic_obstacle), [half](Canvas& canvas, Vector2 centre) {
    canvas.rectangle(centre - half, 2 * half, kMoverFill);
    canvas.rectangle(centre - half, 2 * half, kMoverEdge);
  });
  if (std::ranges::any_of(scene.movers, [](const Mover& mover) { return mover.poses.size() > 1; }))
    legend.add(std::string(words.earlier_place),
               [half](Canvas& canvas, Vector2 centre) { canvas.rectangle(centre - half, 2 * half, kOtherPlace); });
}

void draw_scale_bar(Canvas& canvas, Vector2 corner, double pixels_per_m, double room_px) {
  const auto lengths = round_ticks(0, room_px / pixels_per_m, 2);
  const double length_m = lengths.empty() ? 0 : lengths.back();
  if (!(length_m > 0)) return;
  const Pen pen{Colour::hex(0x22272e), 1.5, {}};
  const Vector2 end = corner + Vector2{length_m * pixels_per_m, 0};
  canvas.line(corner, end, pen);
  for (const Vector2 tip : {corner, end}) canvas.line(tip - Vector2{0, 4}, tip + Vector2{0, 4}, pen);
  canvas.text({corner.x, corner.y + 18}, fmt::format("{} m", tick_label(length_m)));
}

double widest(Canvas& canvas, WordOf word, const TextStyle& style) {
  return std::max(canvas.text_width(words(Language::English).*word, style),
                  canvas.text_width(words(Language::Spanish).*word, style));
}

}  // namespace ganglion::plot
