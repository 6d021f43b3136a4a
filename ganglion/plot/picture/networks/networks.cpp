#include <algorithm>
#include <cmath>

#include "ganglion/plot/canvas/axes.h"
#include "ganglion/plot/picture/picture_kind.h"
#include "ganglion/plot/picture/shapes.h"

namespace ganglion::plot {
namespace {

constexpr Text kAbout{"Nodes, and edges as wide as their weights, as they were shown last.",
                      "Nodos, y aristas tan anchas como sus pesos, como se mostraron por última vez."};
constexpr Vector2 kCorner_px{90, 70}, kSize_px{kPictureWidth_px - 180, 360};
constexpr double kNode_px = 11;

/// Takes the nodes' places to the picture.
Axes axes_of(const shown::Network& network) {
  Vector2 lower{INFINITY, INFINITY}, upper{-INFINITY, -INFINITY};
  for (const shown::Node& node : network.nodes) {
    lower = {std::min(lower.x, node.place.x), std::min(lower.y, node.place.y)};
    upper = {std::max(upper.x, node.place.x), std::max(upper.y, node.place.y)};
  }
  if (!(lower.x <= upper.x)) lower = upper = {};
  if (!(lower.x < upper.x)) lower.x -= 1, upper.x += 1;
  if (!(lower.y < upper.y)) lower.y -= 1, upper.y += 1;
  return {kCorner_px, kSize_px, lower, upper};
}

void draw_edge(Canvas& canvas, Vector2 from, Vector2 to, const shown::Edge& edge, double heaviest) {
  const Vector2 way = to - from;
  if (!(way.length() > 2 * kNode_px)) return;
  const Vector2 unit = way * (1 / way.length());
  const Vector2 tip = to - (kNode_px + 3) * unit;
  const double width_px = 0.8 + 3.2 * std::abs(edge.weight) / heaviest;
  Pen pen = pen_of(edge.role, width_px);
  canvas.line(from + kNode_px * unit, tip - 5 * unit, pen);
  canvas.arrow_head(tip, unit, 9 + width_px, pen.colour);
}

void draw_node(Canvas& canvas, Vector2 at, const shown::Node& node, Language language) {
  const Colour ink = Colour::hex(0x22272e);
  canvas.disc(at, kNode_px, node.role == Role::Plain ? Colour::hex(0xffffff) : colour_of(node.role), {ink, 1.4, {}});
  const std::string words = canvas.fitted(node.title.in(language), 170);
  const double half = canvas.text_width(words) / 2;
  canvas.rectangle({at.x - half - 2, at.y + kNode_px + 3}, {2 * half + 4, 17}, Colour::hex(0xffffff).faded(0.8));
  canvas.text({at.x, at.y + kNode_px + 16}, words, Anchor::Middle);
}

Picture picture_of(const RunView& run, const ExhibitTrack& track, const shown::Network& network, Language language) {
  const Axes axes = axes_of(network);
  std::string title = exhibit_title(run, track, language);
  auto draw = [&network, axes, title, language](Canvas& canvas) {
    canvas.text({16, 26}, canvas.fitted(title, 900), Anchor::Start, {.size_px = 15, .bold = true});
    double heaviest = 1e-12;
    for (const shown::Edge& edge : network.edges) heaviest = std::max(heaviest, std::abs(edge.weight));
    for (const shown::Edge& edge : network.edges) {
      const auto place = [&](int node) { return axes.at(network.nodes[static_cast<std::size_t>(node)].place); };
      draw_edge(canvas, place(edge.from), place(edge.to), edge, heaviest);
    }
    for (const shown::Node& node : network.nodes) draw_node(canvas, axes.at(node.place), node, language);
  };
  return {exhibit_id(track), std::move(title),   std::string(kAbout.in(language)),
          kPictureWidth_px,  axes.bottom() + 60, std::move(draw)};
}

bool wants(const RunView& run) { return !drawn_tracks(run, "network").empty(); }

std::vector<Picture> draw(const RunView& run, Language language) {
  std::vector<Picture> pictures;
  for (const ExhibitTrack* track : drawn_tracks(run, "network")) {
    const auto* network = track->at<shown::Network>(track->times_s.back());
    if (network != nullptr) pictures.push_back(picture_of(run, *track, *network, language));
  }
  return pictures;
}

}  // namespace

extern const PictureKind networks_kind;
constinit const PictureKind networks_kind{
    .descriptor = {.component_class = ComponentClass::Picture,
                   .name = "Networks",
                   .summary = {"Every network that was shown: nodes, and edges as wide as their weights.",
                               "Cada red que se mostró: nodos, y aristas tan anchas como sus pesos."},
                   .source = "ours"},
    .order = 60,
    .wants = wants,
    .draw = draw};

}  // namespace ganglion::plot
