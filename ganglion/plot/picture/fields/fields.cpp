#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <set>

#include "ganglion/plot/picture/fields/panel.h"
#include "ganglion/plot/picture/ground.h"
#include "ganglion/plot/picture/picture_kind.h"
#include "ganglion/plot/picture/shapes.h"

namespace ganglion::plot {
namespace {

constexpr Text kAbout{"Every layer of a field as it was shown last.",
                      "Cada capa de un campo, como se mostró por última vez."};
constexpr double kTop_px = 66, kSideWidth_px = 220, kBelow_px = 74;
constexpr double kForEver = std::numeric_limits<double>::infinity();

/// What one picture needs of a field; it outlives the picture's making.
struct Shown {
  shown::Field field;
  Cells cells;
  std::vector<Panel> panels;

  explicit Shown(shown::Field last) : field(std::move(last)), cells(field, world() ? 1 : 0), panels(panels_of(field)) {}
  Shown(const Shown&) = delete;
  Shown& operator=(const Shown&) = delete;
  bool world() const { return field.frame == "world"; }
};

/// Where each panel stands: one beside the legend, several in two columns above it.
std::vector<Axes> places_of(const Shown& shown) {
  const double left = shown.world() ? 62 : 120;
  const bool one = shown.panels.size() == 1;
  const double width = one ? 620 - (shown.world() ? 0 : 60) : (kPictureWidth_px - 2 * (left + kScaleBar_px)) / 2;
  std::vector<Axes> places;
  double top = kTop_px, lowest = 0;
  for (std::size_t i = 0; i < shown.panels.size(); ++i) {
    const double x = i % 2 == 0 ? left : 2 * left + width + kScaleBar_px;
    const Vector2 room{width, shown.world() ? width : std::min(width * 0.7, 60.0 + 40.0 * shown.field.rows)};
    places.push_back(field_axes(shown.field, shown.cells, {x, top}, room));
    lowest = std::max(lowest, places.back().bottom());
    if (i % 2 == 1) top = lowest + kBelow_px;
  }
  return places;
}

Legend legend_of(const Shown& shown, const Scene& scene, Language language) {
  Legend legend;
  const Vector2 half{9, 8};
  const bool painted = !shown.panels.empty() && !shown.field.layers[shown.panels[0].layer].classes.empty();
  for (const shown::Layer& layer : shown.field.layers) {
    for (const shown::Class& one : layer.classes) {
      if (!painted && look_of(one.role).sign == Sign::None) continue;
      const Colour ground = painted ? colour_of(one.role) : viridis(0.35);
      legend.add(one.title.in(language), [half, ground, role = one.role](Canvas& canvas, Vector2 centre) {
        canvas.rectangle(centre - half, 2 * half, ground);
        draw_sign(canvas, look_of(role).sign, centre, look_of(role).sign == Sign::Hatch ? 8 : 10, role, viridis(0.2));
      });
    }
  }
  legend.add(std::string(words(language).unexplored), [half](Canvas& canvas, Vector2 centre) {
    canvas.rectangle(centre - half, 2 * half, Pen{Colour::hex(0x5b6470), 1, {}});
  });
  if (shown.world() && !(scene.walls.empty() && scene.furniture.empty())) {
    legend.add_line(std::string(words(language).true_outline), {Colour::hex(0x22272e), 1.4, {4, 2, 4, 2}});
  }
  return legend;
}

Picture picture_of(const RunView& run, const ExhibitTrack& track, shown::Field field, Language language) {
  const auto shown = std::make_shared<const Shown>(std::move(field));
  const std::vector<Axes> places = places_of(*shown);
  const Legend legend = legend_of(*shown, run.scene, language);
  double bottom = kTop_px, right = 0;
  for (const Axes& axes : places) bottom = std::max(bottom, axes.bottom()), right = std::max(right, axes.right());
  const bool beside = places.size() == 1;
  const Vector2 side = beside ? Vector2{right + kScaleBar_px + 16, kTop_px} : Vector2{62, bottom + kBelow_px};
  const double scale_px = beside && shown->world() ? 46 : 0;
  const double height_px =
      beside ? std::max(bottom + 56, side.y + legend.height_px() + scale_px + 10) : side.y + legend.height_px() + 16;
  std::string title = exhibit_title(run, track, language);
  auto draw = [&run, shown, places, legend, side, title, language, scale_px](Canvas& canvas) {
    canvas.text({places.empty() ? 16 : places[0].corner_px.x, 26}, canvas.fitted(title, 860), Anchor::Start,
                {.size_px = 15, .bold = true});
    for (std::size_t i = 0; i < places.size(); ++i) {
      draw_panel(canvas, places[i], shown->panels[i], shown->cells, shown->world() ? &run.scene : nullptr, language);
    }
    legend.draw(canvas, side, kSideWidth_px, words(language).legend);
    if (scale_px > 0) {
      draw_scale_bar(canvas, side + Vector2{0, legend.height_px() + 16}, places[0].scale(), kSideWidth_px - 60);
    }
  };
  const double width_px = beside ? side.x + kSideWidth_px + 10 : kPictureWidth_px;
  return {exhibit_id(track), std::move(title), std::string(kAbout.in(language)), width_px, height_px, std::move(draw)};
}

/// A field that is drawn: in the world or with axes of its own.
bool has_place(const shown::Field& field) { return field.frame == "world" || field.frame.empty(); }

bool wants(const RunView& run) { return !drawn_tracks(run, "field").empty(); }

std::vector<Picture> draw(const RunView& run, Language language) {
  std::vector<Picture> pictures;
  for (const ExhibitTrack* track : drawn_tracks(run, "field")) {
    auto field = field_at(*track, kForEver);
    if (field && has_place(*field) && !field->layers.empty()) {
      pictures.push_back(picture_of(run, *track, std::move(*field), language));
    }
  }
  return pictures;
}

}  // namespace

extern const PictureKind fields_kind;
constinit const PictureKind fields_kind{
    .descriptor =
        {.component_class = ComponentClass::Picture,
         .name = "Fields",
         .summary = {"Every field that was shown, such as a learned map: a panel each layer, classes as signs.",
                     "Cada campo que se mostró, como un mapa aprendido: un panel por capa, clases con signos."},
         .source = "ours"},
    .order = 20,
    .wants = wants,
    .draw = draw};

}  // namespace ganglion::plot
