#include "ganglion/plot/canvas/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ganglion::plot {
namespace {

constexpr double kTick_px = 4;
const Pen kFrame{Colour::hex(0x5b6470), 1, {}};
const TextStyle kNumber{Colour::hex(0x3b434d), 11, false, false};
const TextStyle kName{Colour::hex(0x1c2127), 12, false, false};
const TextStyle kUprightName{Colour::hex(0x1c2127), 12, false, true};

int tick_count(double length_px, double per_tick_px) noexcept {
  return std::max(2, static_cast<int>(length_px / per_tick_px));
}

}  // namespace

std::vector<double> round_ticks(double lower, double upper, int at_most) {
  const double range = upper - lower;
  if (!std::isfinite(range) || !(range > 0)) return {};
  const double least = range / at_most;
  const double power = std::pow(10, std::floor(std::log10(least)));
  double step = power;
  for (const double factor : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
    step = factor * power;
    const double count = std::floor(upper / step) - std::ceil(lower / step) + 1;
    if (count <= at_most) break;
  }
  std::vector<double> ticks;
  const double first = std::ceil(lower / step - 1e-9);
  const double last = std::floor(upper / step + 1e-9);
  for (double i = first; i <= last && static_cast<int>(ticks.size()) <= at_most; ++i)
    ticks.push_back(i == 0 ? 0 : i * step);
  return ticks;
}

std::string tick_label(double value) { return fmt::format("{:.4g}", value); }

std::string with_unit(std::string_view name, std::string_view unit) {
  return unit.empty() ? std::string(name) : fmt::format("{} [{}]", name, unit);
}

Vector2 Axes::at(Vector2 value) const noexcept {
  return {corner_px.x + (value.x - lower.x) / (upper.x - lower.x) * size_px.x,
          corner_px.y + size_px.y - (value.y - lower.y) / (upper.y - lower.y) * size_px.y};
}

Axes equal_axes(Vector2 lower, Vector2 upper, Vector2 corner_px, Vector2 room_px) noexcept {
  const Vector2 extent = upper - lower;
  const double scale = std::min(room_px.x / extent.x, room_px.y / extent.y);
  return {corner_px, extent * scale, lower, upper};
}

void draw_time_axis(Canvas& canvas, const Axes& axes, std::string_view name) {
  for (const double x : round_ticks(axes.lower.x, axes.upper.x, tick_count(axes.size_px.x, 60))) {
    const double at = axes.x_at(x);
    canvas.line({at, axes.bottom()}, {at, axes.bottom() + kTick_px}, kFrame);
    canvas.text({at, axes.bottom() + 16}, tick_label(x), Anchor::Middle, kNumber);
  }
  canvas.text({axes.corner_px.x + axes.size_px.x / 2, axes.bottom() + 33}, name, Anchor::Middle, kName);
}

void draw_axes(Canvas& canvas, const Axes& axes, std::string_view x_name, std::string_view y_name) {
  canvas.rectangle(axes.corner_px, axes.size_px, kFrame);
  draw_time_axis(canvas, axes, x_name);
  for (const double y : round_ticks(axes.lower.y, axes.upper.y, tick_count(axes.size_px.y, 50))) {
    const double at = axes.y_at(y);
    canvas.line({axes.corner_px.x - kTick_px, at}, {axes.corner_px.x, at}, kFrame);
    canvas.text({axes.corner_px.x - kTick_px - 3, at + 4}, tick_label(y), Anchor::End, kNumber);
  }
  canvas.text({axes.corner_px.x - 46, axes.corner_px.y + axes.size_px.y / 2}, y_name, Anchor::Middle, kUprightName);
}

}  // namespace ganglion::plot
