#include <algorithm>
#include <cmath>

#include "ganglion/plot/canvas/legend.h"
#include "ganglion/plot/picture/picture_kind.h"
#include "ganglion/plot/picture/shapes.h"
#include "ganglion/plot/picture/words.h"

namespace ganglion::plot {
namespace {

constexpr Text kAbout{"Curves as they were shown last.", "Curvas como se mostraron por última vez."};
constexpr Vector2 kCorner_px{70, 44}, kSize_px{600, 280};
constexpr double kLegendWidth_px = 220;

struct Range {
  Vector2 lower{INFINITY, INFINITY}, upper{-INFINITY, -INFINITY};
};

/// A little wider than all lines, and never empty.
Range range_of(const shown::Curve& curve) {
  Range range;
  for (const shown::Line& line : curve.lines) {
    for (std::size_t i = 0; i < line.x.size(); ++i) {
      range.lower = {std::min(range.lower.x, line.x[i]), std::min(range.lower.y, line.y[i])};
      range.upper = {std::max(range.upper.x, line.x[i]), std::max(range.upper.y, line.y[i])};
    }
  }
  if (!(range.lower.x <= range.upper.x)) return {{0, 0}, {1, 1}};
  const double width = range.upper.x - range.lower.x, height = range.upper.y - range.lower.y;
  range.upper.x += width > 0 ? 0 : 1;
  range.lower.y -= height > 0 ? 0.06 * height : 0.5;
  range.upper.y += height > 0 ? 0.06 * height : 0.5;
  return range;
}

/// Lines of one role are told apart by looks, others by the role's.
Pen pen_for(const shown::Curve& curve, std::size_t index) {
  const Role role = curve.lines[index].role;
  if (std::ranges::count(curve.lines, role, &shown::Line::role) == 1 && role != Role::Plain) return pen_of(role);
  const LineLook line = look(static_cast<int>(index));
  return {line.colour, 2, line.dash_px};
}

Picture picture_of(const RunView& run, const ExhibitTrack& track, const shown::Curve& curve, Language language) {
  const Range range = range_of(curve);
  const Axes axes{kCorner_px, kSize_px, range.lower, range.upper};
  Legend legend;
  for (std::size_t i = 0; i < curve.lines.size(); ++i) {
    legend.add_line(curve.lines[i].title.in(language), pen_for(curve, i));
  }
  const Pen cursor{colour_of(Role::Danger), 1.6, {4, 3, 4, 3}};
  const double at = column_at(run, std::max(0, track.owner.robot), curve.cursor, track.times_s.back());
  const bool inside = std::isfinite(at) && at >= range.lower.x && at <= range.upper.x;
  if (inside) legend.add_line(curve.cursor, cursor);
  std::string title = exhibit_title(run, track, language);
  auto draw = [&curve, axes, legend, title, language, at, inside, cursor](Canvas& canvas) {
    canvas.text({axes.corner_px.x, 26}, canvas.fitted(title, 840), Anchor::Start, {.size_px = 15, .bold = true});
    canvas.clip(axes.corner_px, axes.size_px);
    for (std::size_t i = 0; i < curve.lines.size(); ++i) {
      std::vector<Vector2> points;
      for (std::size_t k = 0; k < curve.lines[i].x.size(); ++k) {
        points.push_back(axes.at({curve.lines[i].x[k], curve.lines[i].y[k]}));
      }
      canvas.line(points, pen_for(curve, i));
    }
    if (inside) canvas.line({axes.x_at(at), axes.corner_px.y}, {axes.x_at(at), axes.bottom()}, cursor);
    canvas.unclip();
    draw_axes(canvas, axes, axis_name(curve.across, language), axis_name(curve.up, language));
    legend.draw(canvas, {axes.right() + 28, axes.corner_px.y}, kLegendWidth_px, words(language).legend);
  };
  const double height_px = kCorner_px.y + std::max(kSize_px.y, legend.height_px()) + 52;
  return {exhibit_id(track), std::move(title), std::string(kAbout.in(language)),
          kPictureWidth_px,  height_px,        std::move(draw)};
}

bool wants(const RunView& run) { return !drawn_tracks(run, "curve").empty(); }

std::vector<Picture> draw(const RunView& run, Language language) {
  std::vector<Picture> pictures;
  for (const ExhibitTrack* track : drawn_tracks(run, "curve")) {
    const auto* curve = track->at<shown::Curve>(track->times_s.back());
    if (curve != nullptr) pictures.push_back(picture_of(run, *track, *curve, language));
  }
  return pictures;
}

}  // namespace

extern const PictureKind curves_kind;
constinit const PictureKind curves_kind{
    .descriptor = {.component_class = ComponentClass::Picture,
                   .name = "Curves",
                   .summary = {"Every curve that was shown, with the place its signal marks.",
                               "Cada curva que se mostró, con el lugar que marca su señal."},
                   .source = "ours"},
    .order = 40,
    .wants = wants,
    .draw = draw};

}  // namespace ganglion::plot
