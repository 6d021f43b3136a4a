#include "ganglion/record/exhibit/keep.h"

#include <algorithm>
#include <cmath>

#include "ganglion/record/exhibit/exhibit_codec.h"

namespace ganglion::shown {
namespace {

Sentence words(const Text& text) {
  return {std::string(text.in(Language::English)), std::string(text.in(Language::Spanish))};
}

Axis words(const ganglion::Axis& axis) {
  Axis kept{words(axis.title), std::string(axis.unit), {}};
  for (const Text& tick : axis.ticks) kept.ticks.push_back(words(tick));
  return kept;
}

double finite(double value) noexcept { return std::isfinite(value) ? value : 0; }

Layer layer_of(const ganglion::Layer& layer) {
  Layer kept{std::string(layer.name), words(layer.title), std::string(layer.unit),
             layer.scale.low,         layer.scale.high,   {}};
  for (const ganglion::Class& one : layer.scale.classes) {
    kept.classes.push_back({one.value, one.role, words(one.title)});
  }
  return kept;
}

bool rises(const Scale& scale) noexcept { return std::isfinite(scale.high - scale.low) && scale.low < scale.high; }

}  // namespace

std::optional<Exhibit> keep(const FrameExhibit& frame) {
  const Pose2& at = frame.fixed;
  return Exhibit{{},
                 Frame{std::string(frame.in),
                       {{finite(at.position.x), finite(at.position.y)}, Angle::from_rad(finite(at.yaw.rad()))},
                       std::string(frame.x_m),
                       std::string(frame.y_m),
                       std::string(frame.yaw_rad)}};
}

std::optional<Exhibit> keep(const FieldExhibit& field) {
  const std::size_t cells =
      static_cast<std::size_t>(std::max(0, field.columns)) * static_cast<std::size_t>(std::max(0, field.rows));
  const bool sized = cells >= 1 && cells <= std::size_t{kMostCells} && field.layers.size() <= std::size_t{kMostLayers};
  const bool placed = std::isfinite(field.origin.x + field.origin.y) && field.cell.x > 0 && field.cell.y > 0;
  const auto whole = [cells](const ganglion::Layer& layer) {
    return layer.values.size() == cells && rises(layer.scale);
  };
  if (!sized || !placed || !std::ranges::all_of(field.layers, whole)) return std::nullopt;
  Field kept;
  kept.frame = field.frame;
  kept.origin = field.origin;
  kept.cell = field.cell;
  kept.columns = field.columns;
  kept.rows = field.rows;
  if (field.across) kept.across = words(*field.across);
  if (field.up) kept.up = words(*field.up);
  for (const ganglion::Layer& layer : field.layers) {
    const Layer& made = kept.layers.emplace_back(layer_of(layer));
    std::vector<std::uint8_t>& bytes = kept.cells.emplace_back(cells);
    std::ranges::transform(layer.values, bytes.begin(), [&made](float value) { return made.byte_of(value); });
  }
  return Exhibit{words(field.title), std::move(kept)};
}

std::optional<Exhibit> keep(const CurveExhibit& curve) {
  Curve kept{words(curve.across), words(curve.up), {}, std::string(curve.cursor)};
  for (const ganglion::Line& line : curve.lines) {
    Line& made = kept.lines.emplace_back(Line{words(line.title), line.role, {}, {}});
    for (std::size_t i = 0; i < std::min(line.x.size(), line.y.size()); ++i) {
      if (!std::isfinite(line.x[i] + line.y[i])) continue;
      made.x.push_back(line.x[i]);
      made.y.push_back(line.y[i]);
    }
  }
  return Exhibit{words(curve.title), std::move(kept)};
}

std::optional<Exhibit> keep(const BarExhibit& bars) {
  Bars kept{words(bars.up), {}};
  for (const ganglion::Bar& bar : bars.bars) {
    if (std::isfinite(bar.value)) kept.bars.push_back({words(bar.title), bar.value, bar.role});
  }
  return Exhibit{words(bars.title), std::move(kept)};
}

std::optional<Exhibit> keep(const MarkExhibit& marks) {
  Marks kept;
  for (const ganglion::Shape& shape : marks.shapes) {
    Shape made{shape.form,
               shape.role,
               std::string(shape.id),
               std::string(shape.frame),
               {},
               finite(shape.radius_m),
               finite(shape.angle_rad),
               std::string(shape.radius),
               shape.label};
    for (const Vector2 point : shape.points) {
      if (std::isfinite(point.x + point.y)) made.points.push_back(point);
    }
    if (!made.points.empty() && made.radius_m >= 0) kept.shapes.push_back(std::move(made));
  }
  return Exhibit{words(marks.title), std::move(kept)};
}

std::optional<Exhibit> keep(const NetworkExhibit& network) {
  Network kept;
  for (const ganglion::Node& node : network.nodes) {
    const Vector2 place{finite(node.place.x), finite(node.place.y)};
    kept.nodes.push_back({words(node.title), place, finite(node.value), node.role});
  }
  const auto inside = [&kept](int node) { return node >= 0 && node < static_cast<int>(kept.nodes.size()); };
  for (const ganglion::Edge& edge : network.edges) {
    if (inside(edge.from) && inside(edge.to)) {
      kept.edges.push_back({edge.from, edge.to, finite(edge.weight), edge.role});
    }
  }
  return Exhibit{words(network.title), std::move(kept)};
}

}  // namespace ganglion::shown
