#include "ganglion/plot/picture/fields/panel.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "ganglion/plot/picture/shapes.h"

namespace ganglion::plot {
namespace {

using Rectangle = std::array<Vector2, 2>;

const Pen kCellEdge{Colour::hex(0xffffff).faded(0.35), 0.6, {}};
const Pen kLine{Colour::hex(0x5b6470), 1, {}};
const Pen kHatch{Colour::hex(0xffffff), 1.1, {}};
const Pen kHatchShade{Colour::hex(0x101418), 2.4, {}};
const Pen kWallHalo{Colour::hex(0xffffff).faded(0.7), 2.6, {}};
const Pen kWallLine{Colour::hex(0x22272e), 1.4, {4, 2, 4, 2}};

/// Pixels of one block, both ways.
Vector2 block_px(const Axes& axes, const Cells& cells) {
  const Vector2 spread = axes.upper - axes.lower;
  return {axes.size_px.x * cells.block().x / spread.x, axes.size_px.y * cells.block().y / spread.y};
}

Colour paint(const shown::Layer& layer, std::uint8_t byte) {
  const shown::Class* one = layer.class_of(byte);
  return one != nullptr ? colour_of(one->role) : viridis(byte / 254.0);
}

void draw_cells(Canvas& canvas, const Axes& axes, const Panel& panel, const Cells& cells) {
  const Vector2 size = block_px(axes, cells);
  std::map<std::uint8_t, std::vector<Rectangle>> by_value;
  cells.for_each(panel.layer, [&](Vector2 lower, std::uint8_t byte) {
    by_value[byte].push_back({axes.at(lower + Vector2{0, cells.block().y}), size});
  });
  const shown::Layer& layer = panel.field->layers[panel.layer];
  for (const auto& [byte, same] : by_value) canvas.rectangles(same, paint(layer, byte));
  if (std::min(size.x, size.y) < 8) return;
  for (double x = axes.lower.x; x <= axes.upper.x + cells.block().x / 2; x += cells.block().x) {
    canvas.line({axes.x_at(x), axes.corner_px.y}, {axes.x_at(x), axes.bottom()}, kCellEdge);
  }
  for (double y = axes.lower.y; y <= axes.upper.y + cells.block().y / 2; y += cells.block().y) {
    canvas.line({axes.corner_px.x, axes.y_at(y)}, {axes.right(), axes.y_at(y)}, kCellEdge);
  }
}

/// What of a layer of classes has a sign; a cross covers a dot.
void draw_signs(Canvas& canvas, const Axes& axes, const Panel& panel, const Cells& cells) {
  const Vector2 size = block_px(axes, cells);
  const double side_px = std::min(size.x, size.y), mark_px = std::clamp(side_px * 0.5, 5.0, 12.0);
  std::vector<Rectangle> hatched;
  std::map<std::pair<double, double>, const shown::Class*> marks;
  for (const std::size_t index : panel.signs) {
    const shown::Layer& layer = panel.field->layers[index];
    cells.for_each(index, [&](Vector2 lower, std::uint8_t byte) {
      const shown::Class* one = layer.class_of(byte);
      const Sign sign = one != nullptr ? look_of(one->role).sign : Sign::None;
      const Vector2 corner = axes.at(lower + Vector2{0, cells.block().y});
      if (sign == Sign::Hatch) hatched.push_back({corner, size});
      if (sign == Sign::Dot) marks.try_emplace({corner.x, corner.y}, one);
      if (sign == Sign::Cross) marks[{corner.x, corner.y}] = one;
    });
  }
  const double gap_px = std::clamp(side_px / 3, 4.0, 9.0);
  canvas.hatch(hatched, gap_px, kHatchShade);
  canvas.hatch(hatched, gap_px, kHatch);
  if (side_px < 6) return;
  for (const auto& [corner, one] : marks) {
    const Vector2 centre = Vector2{corner.first, corner.second} + size * 0.5;
    draw_sign(canvas, look_of(one->role).sign, centre, mark_px, one->role, viridis(0.2));
  }
}

void draw_true_walls(Canvas& canvas, const Axes& axes, const Scene& scene) {
  for (const auto* outlines : {&scene.walls, &scene.furniture}) {
    for (const Outline& outline : *outlines) {
      std::vector<Vector2> points;
      for (const Vector2 p : outline.points) points.push_back(axes.at(p));
      if (outline.closed && !points.empty()) points.push_back(points.front());
      canvas.line(points, kWallHalo);
      canvas.line(points, kWallLine);
    }
  }
}

void draw_scale(Canvas& canvas, Vector2 corner, double height_px, const shown::Layer& layer) {
  constexpr double kBar_px = 16;
  constexpr int kSteps = 64;
  for (int i = 0; i < kSteps; ++i) {
    canvas.rectangle(corner + Vector2{0, height_px * (kSteps - 1 - i) / kSteps}, {kBar_px, height_px / kSteps + 0.6},
                     viridis((i + 0.5) / kSteps));
  }
  canvas.rectangle(corner, {kBar_px, height_px}, kLine);
  for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double y = corner.y + height_px * (1 - part);
    canvas.line({corner.x + kBar_px, y}, {corner.x + kBar_px + 4, y}, kLine);
    canvas.text({corner.x + kBar_px + 8, y + 4}, tick_label(layer.low + part * (layer.high - layer.low)), Anchor::Start,
                {.size_px = 11});
  }
}

/// Terms at the middle of their cells; an axis without a description counts cells.
void draw_own_axes(Canvas& canvas, const Axes& axes, const shown::Field& field, Language language) {
  canvas.rectangle(axes.corner_px, axes.size_px, kLine);
  const auto word = [&](const std::optional<shown::Axis>& axis, int index, double value) {
    const auto i = static_cast<std::size_t>(index);
    return axis && i < axis->ticks.size() ? axis->ticks[i].in(language) : tick_label(value);
  };
  const TextStyle small{.size_px = 11};
  const int every = std::max(1, field.columns / 8);
  for (int column = 0; column < field.columns; column += every) {
    const double x = field.origin.x + (column + 0.5) * field.cell.x;
    const double room_px = axes.size_px.x * every / field.columns - 6;
    canvas.text({axes.x_at(x), axes.bottom() + 16}, canvas.fitted(word(field.across, column, x), room_px, small),
                Anchor::Middle, small);
  }
  for (int row = 0; row < field.rows; row += std::max(1, field.rows / 8)) {
    const double y = field.origin.y + (row + 0.5) * field.cell.y;
    canvas.text({axes.corner_px.x - 6, axes.y_at(y) + 4}, canvas.fitted(word(field.up, row, y), 70, small), Anchor::End,
                small);
  }
  if (field.across) {
    canvas.text({axes.corner_px.x + axes.size_px.x / 2, axes.bottom() + 36}, axis_name(*field.across, language),
                Anchor::Middle);
  }
  if (field.up) {
    canvas.text({axes.corner_px.x - 84, axes.corner_px.y + axes.size_px.y / 2}, axis_name(*field.up, language),
                Anchor::Middle, {.upright = true});
  }
}

}  // namespace

std::vector<Panel> panels_of(const shown::Field& field) {
  std::vector<Panel> panels;
  std::vector<std::size_t> classes;
  for (std::size_t i = 0; i < field.layers.size(); ++i) {
    if (field.layers[i].classes.empty()) {
      panels.push_back({&field, i, {}});
    } else {
      classes.push_back(i);
    }
  }
  for (Panel& panel : panels) panel.signs = classes;
  if (!panels.empty()) return panels;
  for (const std::size_t i : classes) panels.push_back({&field, i, {i}});
  return panels;
}

Axes field_axes(const shown::Field& field, const Cells& cells, Vector2 corner_px, Vector2 room_px) {
  if (field.frame == "world") return equal_axes(cells.lower(), cells.upper(), corner_px, room_px);
  return {corner_px, room_px, cells.lower(), cells.upper()};
}

void draw_panel(Canvas& canvas, const Axes& axes, const Panel& panel, const Cells& cells, const Scene* scene,
                Language language) {
  const shown::Layer& layer = panel.field->layers[panel.layer];
  canvas.text(axes.corner_px - Vector2{0, 10}, with_unit(layer.title.in(language), layer.unit), Anchor::Start,
              {.size_px = 12, .bold = true});
  canvas.clip(axes.corner_px, axes.size_px);
  draw_cells(canvas, axes, panel, cells);
  draw_signs(canvas, axes, panel, cells);
  if (scene != nullptr) draw_true_walls(canvas, axes, *scene);
  canvas.unclip();
  if (panel.field->frame == "world") {
    draw_axes(canvas, axes, "x [m]", "y [m]");
  } else {
    draw_own_axes(canvas, axes, *panel.field, language);
  }
  if (layer.classes.empty()) {
    draw_scale(canvas, {axes.right() + 12, axes.corner_px.y}, std::min(150.0, axes.size_px.y), layer);
  }
}

}  // namespace ganglion::plot
