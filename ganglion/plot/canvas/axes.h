#pragma once

#include <string>
#include <vector>

#include "ganglion/plot/canvas/canvas.h"

namespace ganglion::plot {

/// Round numbers (1, 2 or 5 times a power of ten apart) within [lower, upper], at most `at_most` of them (>= 2).
/// Empty where the range is not finite or empty.
std::vector<double> round_ticks(double lower, double upper, int at_most);

/// A number as short as a tick needs: "0.25", "1200", "3e-07".
std::string tick_label(double value);

/// Name and unit of an axis: "time [s]", or the name alone for "".
std::string with_unit(std::string_view name, std::string_view unit);

/// A rectangle of the picture that stands for a range of values; y grows upwards.
struct Axes {
  Vector2 corner_px;  ///< Upper left.
  Vector2 size_px;
  Vector2 lower;  ///< Values at the lower left corner.
  Vector2 upper;

  Vector2 at(Vector2 value) const noexcept;
  double x_at(double value) const noexcept { return at({value, 0}).x; }
  double y_at(double value) const noexcept { return at({0, value}).y; }
  /// Pixels per unit, along x.
  double scale() const noexcept { return size_px.x / (upper.x - lower.x); }
  double right() const noexcept { return corner_px.x + size_px.x; }
  double bottom() const noexcept { return corner_px.y + size_px.y; }
};

/// Axes of equal scale both ways that show at least [lower, upper] and fit into `room_px`.
Axes equal_axes(Vector2 lower, Vector2 upper, Vector2 corner_px, Vector2 room_px) noexcept;

/// Frame, ticks and numbers below and to the left, names of the axes.
void draw_axes(Canvas& canvas, const Axes& axes, std::string_view x_name, std::string_view y_name);

/// Ticks with numbers along the lower edge only.
void draw_time_axis(Canvas& canvas, const Axes& axes, std::string_view name);

}  // namespace ganglion::plot
