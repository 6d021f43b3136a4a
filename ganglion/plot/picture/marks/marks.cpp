#include <algorithm>

#include "ganglion/plot/picture/ground.h"
#include "ganglion/plot/picture/picture_kind.h"
#include "ganglion/plot/picture/shapes.h"

namespace ganglion::plot {
namespace {

constexpr Text kTitle{"Marks at the end", "Marcas al final"};
constexpr Text kAbout{"What was shown in the world at the end of the run.", "Lo que se mostraba en el mundo al final."};
constexpr double kLegendWidth_px = 220;
constexpr double kForEver = 1e300;

/// What no other picture shows: of roles that pass, and no plan.
bool is_of_the_moment(const PlacedShape& placed) {
  return placed.shape->role != Role::Plan && !look_of(placed.shape->role).lasts;
}

bool wants(const RunView& run) {
  const std::vector<PlacedShape> shapes = shapes_at(run, kForEver);
  const bool other = run.scene.bounds || has_way(run);
  return !shapes.empty() && (!other || std::ranges::any_of(shapes, is_of_the_moment));
}

std::vector<Picture> draw(const RunView& run, Language language) {
  std::vector<PlacedShape> shapes = shapes_at(run, kForEver);
  const Bounds bounds = bounds_of(run);
  const Vector2 margin = 0.05 * (bounds.upper - bounds.lower);
  const Vector2 corner{62, 44};
  const Vector2 room{kPictureWidth_px - corner.x - kLegendWidth_px - 40, 620};
  const Axes axes = equal_axes(bounds.lower - margin, bounds.upper + margin, corner, room);
  Legend legend;
  add_shapes_to_legend(legend, shapes, language);
  add_ground_to_legend(legend, run.scene, words(language));
  const double left = axes.right() + 28;
  const double height_px = corner.y + std::max(axes.size_px.y, legend.height_px() + 60) + 48;
  auto draw = [&run, axes, legend, left, language, shapes = std::move(shapes)](Canvas& canvas) {
    canvas.text({axes.corner_px.x, 26}, canvas.fitted(fmt::format("{}: {}", kTitle.in(language), run.name), left + 150),
                Anchor::Start, {.size_px = 15, .bold = true});
    draw_ground(canvas, axes, run.scene, run.duration_s);
    canvas.clip(axes.corner_px, axes.size_px);
    draw_shapes(canvas, axes, shapes, language);
    canvas.unclip();
    draw_axes(canvas, axes, "x [m]", "y [m]");
    legend.draw(canvas, {left, axes.corner_px.y}, kLegendWidth_px, words(language).legend);
    draw_scale_bar(canvas, {left, axes.corner_px.y + legend.height_px() + 22}, axes.scale(), kLegendWidth_px - 60);
  };
  return {{"marks", std::string(kTitle.in(language)), std::string(kAbout.in(language)), left + kLegendWidth_px + 10,
           height_px, std::move(draw)}};
}

}  // namespace

extern const PictureKind marks_kind;
constinit const PictureKind marks_kind{
    .descriptor = {.component_class = ComponentClass::Picture,
                   .name = "Marks",
                   .summary = {"The shapes that were shown in the world at the end, each where its frame was.",
                               "Las formas que se mostraban en el mundo al final, cada una donde estaba su marco."},
                   .source = "ours"},
    .order = 15,
    .wants = wants,
    .draw = draw};

}  // namespace ganglion::plot
