#include "ganglion/plot/canvas/canvas.h"

#include <algorithm>
#include <cmath>

#include "ganglion/units/angle.h"

namespace ganglion::plot {
namespace {

bool finite(Vector2 p) noexcept { return std::isfinite(p.x) && std::isfinite(p.y); }

}  // namespace

void Canvas::trace(std::span<const Vector2> points, bool closed) {
  bool begun = false;
  for (const Vector2 p : points) {
    if (!finite(p)) continue;
    if (begun)
      cairo_line_to(context_, p.x, p.y);
    else
      cairo_move_to(context_, p.x, p.y);
    begun = true;
  }
  if (closed && begun) cairo_close_path(context_);
}

void Canvas::stroke(const Pen& pen) {
  cairo_set_source_rgba(context_, pen.colour.red, pen.colour.green, pen.colour.blue, pen.colour.alpha);
  cairo_set_line_width(context_, pen.width_px);
  cairo_set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
  const bool dashed = pen.dash_px[0] > 0;
  cairo_set_dash(context_, pen.dash_px.data(), dashed ? static_cast<int>(pen.dash_px.size()) : 0, 0);
  cairo_stroke(context_);
}

void Canvas::fill(Colour colour, bool keep) {
  cairo_set_source_rgba(context_, colour.red, colour.green, colour.blue, colour.alpha);
  if (keep)
    cairo_fill_preserve(context_);
  else
    cairo_fill(context_);
}

void Canvas::line(std::span<const Vector2> points, const Pen& pen) {
  if (points.size() < 2) return;
  trace(points, false);
  stroke(pen);
}

void Canvas::line(Vector2 from, Vector2 to, const Pen& pen) {
  const std::array<Vector2, 2> ends{from, to};
  line(ends, pen);
}

void Canvas::polygon(std::span<const Vector2> points, Colour colour) {
  trace(points, true);
  fill(colour);
}

void Canvas::polygon(std::span<const Vector2> points, Colour colour, const Pen& edge) {
  trace(points, true);
  fill(colour, true);
  stroke(edge);
}

void Canvas::polygons(std::span<const std::vector<Vector2>> shapes, Colour colour) {
  for (const std::vector<Vector2>& shape : shapes) trace(shape, true);
  fill(colour);
}

void Canvas::rectangles(std::span<const std::array<Vector2, 2>> corners_and_sizes, Colour colour) {
  for (const auto& [corner, size] : corners_and_sizes) cairo_rectangle(context_, corner.x, corner.y, size.x, size.y);
  fill(colour);
}

void Canvas::rectangle(Vector2 corner, Vector2 size, Colour colour) {
  cairo_rectangle(context_, corner.x, corner.y, size.x, size.y);
  fill(colour);
}

void Canvas::rectangle(Vector2 corner, Vector2 size, const Pen& edge) {
  cairo_rectangle(context_, corner.x, corner.y, size.x, size.y);
  stroke(edge);
}

void Canvas::disc(Vector2 centre, double radius_px, Colour colour) {
  if (!finite(centre)) return;
  cairo_new_sub_path(context_);
  cairo_arc(context_, centre.x, centre.y, radius_px, 0, 2 * kPi);
  fill(colour);
}

void Canvas::disc(Vector2 centre, double radius_px, Colour colour, const Pen& edge) {
  if (!finite(centre)) return;
  cairo_new_sub_path(context_);
  cairo_arc(context_, centre.x, centre.y, radius_px, 0, 2 * kPi);
  fill(colour, true);
  stroke(edge);
}

void Canvas::marker(int kind, Vector2 centre, double size_px, Colour colour) {
  const double r = size_px / 2;
  const auto at = [&](double x, double y) { return centre + Vector2{x * r, y * r}; };
  const Pen thick{colour, std::max(1.2, size_px / 4), {}};
  switch (kind) {
    case 0:
      return disc(centre, r, colour);
    case 1:
      return polygon(std::array{at(0, -1.1), at(1, 0.8), at(-1, 0.8)}, colour);
    case 2:
      return rectangle(at(-0.9, -0.9), Vector2{1.8 * r, 1.8 * r}, colour);
    case 3:
      return polygon(std::array{at(0, -1.25), at(1.1, 0), at(0, 1.25), at(-1.1, 0)}, colour);
    case 4:
      line(at(-1, -1), at(1, 1), thick);
      return line(at(-1, 1), at(1, -1), thick);
    case 5:
      line(at(-1.15, 0), at(1.15, 0), thick);
      return line(at(0, -1.15), at(0, 1.15), thick);
    case 6:
      return disc(centre, r * 0.9, Colour::hex(0xffffff), thick);
    default:
      line(at(0, -1.15), at(0, 1.15), thick), line(at(-1, -0.6), at(1, 0.6), thick);
      return line(at(-1, 0.6), at(1, -0.6), thick);
  }
}

void Canvas::arrow_head(Vector2 tip, Vector2 heading, double size_px, Colour colour) {
  const double length = heading.length();
  if (!(length > 0) || !finite(tip)) return;
  const Vector2 along = heading * (size_px / length);
  const Vector2 aside = along.left() * 0.45;
  polygon(std::array{tip + 0.5 * along, tip - 0.5 * along + aside, tip - 0.25 * along, tip - 0.5 * along - aside},
          colour);
}

void Canvas::hatch(std::span<const std::array<Vector2, 2>> rectangles, double gap_px, const Pen& pen) {
  if (rectangles.empty()) return;
  Vector2 lower = rectangles[0][0];
  Vector2 upper = lower;
  cairo_save(context_);
  for (const auto& [corner, size] : rectangles) {
    cairo_rectangle(context_, corner.x, corner.y, size.x, size.y);
    lower = {std::min(lower.x, corner.x), std::min(lower.y, corner.y)};
    upper = {std::max(upper.x, corner.x + size.x), std::max(upper.y, corner.y + size.y)};
  }
  cairo_clip(context_);
  const double height = upper.y - lower.y;
  for (double x = lower.x - height; x < upper.x; x += gap_px) {
    cairo_move_to(context_, x, upper.y);
    cairo_line_to(context_, x + height, lower.y);
  }
  stroke(pen);
  cairo_restore(context_);
}

void Canvas::use_font(const TextStyle& style) {
  cairo_select_font_face(context_, "sans", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context_, style.size_px);
}

double Canvas::text_width(std::string_view words, const TextStyle& style) {
  use_font(style);
  cairo_text_extents_t extents{};
  cairo_text_extents(context_, clean_text(words).c_str(), &extents);
  return extents.x_advance;
}

std::string Canvas::fitted(std::string_view words, double width_px, const TextStyle& style) {
  std::string text = clean_text(words);
  if (text_width(text, style) <= width_px) return text;
  while (!text.empty() && text_width(text + "…", style) > width_px) {
    while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80) text.pop_back();
    text.pop_back();
  }
  return text + "…";
}

void Canvas::text(Vector2 place, std::string_view words, Anchor anchor, const TextStyle& style) {
  const std::string cleaned = clean_text(words);
  const double width = text_width(cleaned, style);
  if (cleaned.empty() || !finite(place)) return;
  if (gathered_ != nullptr) return gathered_->push_back({cleaned, place, width, anchor, style});
  const double back = anchor == Anchor::Start ? 0 : anchor == Anchor::Middle ? width / 2 : width;
  cairo_save(context_);
  cairo_translate(context_, place.x, place.y);
  if (style.upright) cairo_rotate(context_, -kPi / 2);
  cairo_move_to(context_, -back, 0);
  cairo_set_source_rgba(context_, style.colour.red, style.colour.green, style.colour.blue, style.colour.alpha);
  cairo_show_text(context_, cleaned.c_str());
  cairo_restore(context_);
}

void Canvas::clip(Vector2 corner, Vector2 size) {
  cairo_save(context_);
  cairo_rectangle(context_, corner.x, corner.y, size.x, size.y);
  cairo_clip(context_);
}

void Canvas::unclip() { cairo_restore(context_); }

}  // namespace ganglion::plot
