#include "ganglion/plot/picture/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "ganglion/math/functions.h"
#include "ganglion/plot/canvas/picture.h"
#include "ganglion/plot/picture/picture_kind.h"

namespace ganglion::plot {
namespace {

const Colour kInk = Colour::hex(0x22272e);
constexpr double kDisc_px = 8;  // of a disc without a size
constexpr int kArcPoints = 24;

std::vector<Vector2> points_of(const Axes& axes, const PlacedShape& placed) {
  std::vector<Vector2> points;
  for (const Vector2 point : placed.shape->points) points.push_back(axes.at(placed.frame.to_outer(point)));
  return points;
}

void draw_disc(Canvas& canvas, Vector2 at, double radius_px, Role role) {
  if (look_of(role).filled) {
    canvas.disc(at, radius_px, colour_of(role), {kInk, 1.2, {}});
  } else {
    canvas.disc(at, radius_px, colour_of(role).faded(0.12), pen_of(role, 1.6));
  }
  const double half = radius_px * 0.75;
  if (look_of(role).sign == Sign::Cross) {
    canvas.line(at + Vector2{-half, half}, at + Vector2{half, -half}, {kInk, 1.8, {}});
    canvas.line(at + Vector2{-half, -half}, at + Vector2{half, half}, {kInk, 1.8, {}});
  }
}

void draw_polygon(Canvas& canvas, std::vector<Vector2> points, Role role) {
  if (look_of(role).filled) canvas.polygon(points, colour_of(role).faded(0.45));
  if (!points.empty()) points.push_back(points.front());
  canvas.line(points, pen_of(role, 1.6));
}

void draw_sector(Canvas& canvas, const Axes& axes, const PlacedShape& placed) {
  const shown::Shape& shape = *placed.shape;
  const Vector2 at = shape.points.front();
  std::vector<Vector2> points = {axes.at(placed.frame.to_outer(at))};
  for (int i = 0; i <= kArcPoints; ++i) {
    const double angle = shape.angle_rad * (static_cast<double>(i) / kArcPoints - 0.5);
    const Vector2 edge = at + placed.radius_m * Vector2{math::cos(angle), math::sin(angle)};
    points.push_back(axes.at(placed.frame.to_outer(edge)));
  }
  canvas.polygon(points, colour_of(shape.role).faded(0.12));
  points.push_back(points.front());
  canvas.line(points, pen_of(shape.role, 1.4));
}

void draw_shape(Canvas& canvas, const Axes& axes, const PlacedShape& placed) {
  const shown::Shape& shape = *placed.shape;
  const std::vector<Vector2> points = points_of(axes, placed);
  switch (shape.form) {
    case Form::Polyline:
      return canvas.line(points, pen_of(shape.role));
    case Form::Polygon:
      return draw_polygon(canvas, points, shape.role);
    case Form::Disc:
      return draw_disc(canvas, points.front(),
                       std::max(placed.radius_m * axes.scale(), shape.radius_m > 0 ? 4 : kDisc_px), shape.role);
    case Form::Sector:
      return draw_sector(canvas, axes, placed);
    case Form::Point:
      return canvas.disc(points.front(), 4, colour_of(shape.role), {Colour::hex(0xffffff), 1, {}});
    case Form::Label:
      break;
  }
}

void draw_label(Canvas& canvas, const Axes& axes, const PlacedShape& placed, Language language) {
  const shown::Shape& shape = *placed.shape;
  const std::string& words = shape.label.in(language);
  if (words.empty()) return;
  Vector2 at{};
  const std::vector<Vector2> points = points_of(axes, placed);
  for (const Vector2 point : points) at += point * (1 / static_cast<double>(points.size()));
  if (shape.form == Form::Disc) {
    if (look_of(shape.role).sign == Sign::Cross) return;
    return canvas.text(at + Vector2{0, 3.5}, words, Anchor::Middle, {.size_px = 10, .bold = true});
  }
  const double half = canvas.text_width(words) / 2;
  const double x =
      std::clamp(at.x, axes.corner_px.x + half + 3, std::max(axes.corner_px.x + half + 3, axes.right() - half - 3));
  const double drop = shape.form == Form::Polygon ? 4 : 18;
  canvas.rectangle({x - half - 2, at.y + drop - 12}, {2 * half + 4, 16}, Colour::hex(0xffffff).faded(0.75));
  canvas.text({x, at.y + drop}, words, Anchor::Middle);
}

void draw_sample(Canvas& canvas, Vector2 centre, Form form, Role role) {
  const Vector2 half{12, 6};
  switch (form) {
    case Form::Disc:
      return draw_disc(canvas, centre, 7, role);
    case Form::Point:
      return canvas.disc(centre, 4, colour_of(role), {Colour::hex(0xffffff), 1, {}});
    case Form::Polygon:
      return draw_polygon(canvas, {centre - half, centre + Vector2{12, -6}, centre + half, centre + Vector2{-12, 6}},
                          role);
    case Form::Sector:
      return draw_polygon(canvas, {centre - Vector2{13, 0}, centre + Vector2{13, -6}, centre + Vector2{13, 6}}, role);
    case Form::Polyline:
    case Form::Label:
      break;
  }
  canvas.line(centre - Vector2{15, 0}, centre + Vector2{15, 0}, pen_of(role));
}

}  // namespace

Colour colour_of(Role role) noexcept { return Colour::hex(look_of(role).light); }

Pen pen_of(Role role, double width_px) noexcept {
  const auto dash = look_of(role).dash;
  return {colour_of(role), width_px, {dash[0], dash[1], dash[0], dash[1]}};
}

void draw_shapes(Canvas& canvas, const Axes& axes, std::span<const PlacedShape> shapes, Language language) {
  for (const PlacedShape& placed : shapes) draw_shape(canvas, axes, placed);
  for (const PlacedShape& placed : shapes) draw_label(canvas, axes, placed, language);
}

void add_shapes_to_legend(Legend& legend, std::span<const PlacedShape> shapes, Language language) {
  std::map<std::pair<Role, Form>, bool> seen;
  for (const PlacedShape& placed : shapes) {
    if (placed.shape->form != Form::Label) seen[{placed.shape->role, placed.shape->form}] = true;
  }
  for (const auto& [what, any] : seen) {
    const auto [role, form] = what;
    legend.add(std::string(look_of(role).word.in(language)),
               [role = role, form = form](Canvas& canvas, Vector2 centre) { draw_sample(canvas, centre, form, role); });
  }
}

void draw_sign(Canvas& canvas, Sign sign, Vector2 centre, double size_px, Role role, Colour ground) {
  const Colour white = Colour::hex(0xffffff), black = Colour::hex(0x101418);
  switch (sign) {
    case Sign::None:
      return;
    case Sign::Dot:
      return canvas.disc(centre, size_px / 5, ground.brightness() > 0.5 ? black : white);
    case Sign::Cross:
      canvas.marker(4, centre, size_px + 2, colour_of(role));
      return canvas.marker(4, centre, size_px - 1, white);
    case Sign::Hatch:
      break;
  }
  const Vector2 half{size_px, size_px};
  const std::array<std::array<Vector2, 2>, 1> box = {std::array{centre - half, 2 * half}};
  const double gap_px = std::clamp(size_px * 2 / 3, 4.0, 9.0);
  canvas.hatch(box, gap_px, {black, 2.4, {}});
  canvas.hatch(box, gap_px, {white, 1.1, {}});
}

std::vector<const ExhibitTrack*> drawn_tracks(const RunView& run, std::string_view form) {
  std::vector<const ExhibitTrack*> tracks;
  for (const ExhibitTrack& track : run.exhibits) {
    const bool near = track.owner.robot < static_cast<int>(kMaxDrawnRobots);
    if (track.form == form && near && !track.states.empty()) tracks.push_back(&track);
  }
  return tracks;
}

std::string exhibit_title(const RunView& run, const ExhibitTrack& track, Language language) {
  std::string title = track.title().in(language) + ":";
  const auto robot = static_cast<std::size_t>(std::max(0, track.owner.robot));
  if (track.owner.robot >= 0 && robot < run.robots.size()) title += " " + run.robots[robot].name;
  if (!track.owner.name.empty()) title += " " + track.owner.name;
  return title + fmt::format("{} {:.4g} s", title.ends_with(':') ? "" : ",", track.times_s.back());
}

std::string exhibit_id(const ExhibitTrack& track) {
  const std::string robot = track.owner.robot >= 0 ? fmt::format("robot{}-", track.owner.robot) : "";
  return file_stem(fmt::format("{}-{}{}-{}", track.form, robot, track.owner.name, track.name));
}

std::string axis_name(const shown::Axis& axis, Language language) {
  return with_unit(axis.title.in(language), axis.unit);
}

}  // namespace ganglion::plot
