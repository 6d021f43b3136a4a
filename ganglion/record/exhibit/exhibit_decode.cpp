#include <google/protobuf/stubs/logging.h>

#include <algorithm>
#include <cmath>

#include "ganglion/record/exhibit/exhibit.pb.h"
#include "ganglion/record/exhibit/exhibit_codec.h"

namespace ganglion {
namespace {

constexpr std::size_t kMostText = 400;
constexpr double kFarthest = 1e9;  // what is farther off, in whatever unit, is no drawing

/// Reads one message; once it finds what cannot be, good() is false and what was read counts for nothing.
class Taker {
 public:
  bool good() const noexcept { return good_; }
  bool require(bool holds) noexcept { return good_ = good_ && holds; }

  std::string text(const std::string& from) {
    require(from.size() <= kMostText);
    return from.substr(0, kMostText);
  }
  Sentence words(const Exhibit_Words& from) {
    Sentence said{text(from.en()), text(from.es())};
    if (said.es.empty()) said.es = said.en;
    return said;
  }
  double number(double value) {
    require(std::abs(value) <= kFarthest);  // NaN is not
    return value;
  }
  static Role role(const std::string& name) { return role_named(name).value_or(Role::Plain); }
  /// Whether a list is of a length that may be; else it is not read.
  template <class List>
  bool fits(const List& list, int most = kMostListed) {
    return require(list.size() <= most);
  }

  shown::Axis take(const Exhibit_Axis& from) {
    shown::Axis axis{words(from.title()), text(from.unit()), {}};
    if (fits(from.ticks(), 1000)) {
      for (const auto& tick : from.ticks()) axis.ticks.push_back(words(tick));
    }
    return axis;
  }

  shown::Frame take(const Exhibit_Frame& from) {
    return {text(from.in()),
            {{number(from.x()), number(from.y())}, Angle::from_rad(number(from.yaw()))},
            text(from.x_column()),
            text(from.y_column()),
            text(from.yaw_column())};
  }

  shown::Layer take(const Exhibit_Layer& from) {
    shown::Layer layer{text(from.name()), words(from.title()), text(from.unit()), from.low(), from.high(), {}};
    require(std::isfinite(layer.low) && std::isfinite(layer.high) && std::isfinite(layer.high - layer.low) &&
            layer.low < layer.high);
    if (fits(from.classes(), 255)) {
      for (const auto& one : from.classes()) {
        layer.classes.push_back({number(one.value()), role(one.role()), words(one.title())});
      }
    }
    return layer;
  }

  template <class From>
  std::vector<std::vector<std::uint8_t>> cells(const From& from, std::uint32_t columns, std::uint32_t rows) {
    std::vector<std::vector<std::uint8_t>> layers;
    const std::uint64_t count = std::uint64_t{columns} * rows;
    if (!require(count >= 1 && count <= kMostCells) || !fits(from.cells(), kMostLayers)) return layers;
    for (const std::string& bytes : from.cells()) {
      if (require(bytes.size() == count)) layers.emplace_back(bytes.begin(), bytes.end());
    }
    return layers;
  }

  shown::Field take(const Exhibit_Field& from) {
    shown::Field field;
    field.frame = text(from.frame());
    field.origin = {number(from.x()), number(from.y())};
    field.cell = {number(from.cell_x()), number(from.cell_y())};
    require(field.cell.x > 0 && field.cell.y > 0);
    if (!require(from.columns() <= kMostCells && from.rows() <= kMostCells)) return field;
    field.columns = static_cast<int>(from.columns());
    field.rows = static_cast<int>(from.rows());
    number(field.origin.x + field.columns * field.cell.x);
    number(field.origin.y + field.rows * field.cell.y);
    if (from.has_across()) field.across = take(from.across());
    if (from.has_up()) field.up = take(from.up());
    if (!fits(from.layers(), kMostLayers) || !require(from.layers_size() == from.cells_size())) return field;
    for (const auto& layer : from.layers()) field.layers.push_back(take(layer));
    field.cells = cells(from, from.columns(), from.rows());
    return field;
  }

  shown::Patch take(const Exhibit_Patch& from) {
    shown::Patch patch;
    if (!require(std::max({from.column(), from.row(), from.columns(), from.rows()}) <= kMostCells)) return patch;
    patch = {static_cast<int>(from.column()), static_cast<int>(from.row()), static_cast<int>(from.columns()),
             static_cast<int>(from.rows()), cells(from, from.columns(), from.rows())};
    return patch;
  }

  shown::Curve take(const Exhibit_Curve& from) {
    shown::Curve curve{take(from.across()), take(from.up()), {}, text(from.cursor())};
    if (!fits(from.lines(), 1000)) return curve;
    int points = 0;
    for (const auto& one : from.lines()) {
      shown::Line line{words(one.title()), role(one.role()), {}, {}};
      points += one.x_size();
      if (!require(one.x_size() == one.y_size() && points <= kMostPoints)) return curve;
      for (int i = 0; i < one.x_size(); ++i) {
        if (!(std::abs(one.x(i)) <= kFarthest && std::abs(one.y(i)) <= kFarthest)) continue;
        line.x.push_back(one.x(i));
        line.y.push_back(one.y(i));
      }
      curve.lines.push_back(std::move(line));
    }
    return curve;
  }

  shown::Bars take(const Exhibit_Bars& from) {
    shown::Bars bars{take(from.up()), {}};
    if (!fits(from.bars(), 1000)) return bars;
    for (const auto& bar : from.bars())
      bars.bars.push_back({words(bar.title()), number(bar.value()), role(bar.role())});
    return bars;
  }

  shown::Marks take(const Exhibit_Marks& from) {
    shown::Marks marks;
    if (!fits(from.shapes())) return marks;
    int points = 0;
    for (const auto& one : from.shapes()) {
      points += one.xy_size() / 2;
      const bool sound = one.form() <= static_cast<std::uint32_t>(Form::Label) && one.xy_size() % 2 == 0;
      if (!require(sound && points <= kMostPoints)) return marks;
      shown::Shape shape{static_cast<Form>(one.form()),
                         role(one.role()),
                         text(one.id()),
                         text(one.frame()),
                         {},
                         number(one.radius()),
                         number(one.angle()),
                         text(one.radius_column()),
                         {}};
      for (int i = 0; i + 1 < one.xy_size(); i += 2) shape.points.push_back({number(one.xy(i)), number(one.xy(i + 1))});
      if (one.has_label()) shape.label = words(one.label());
      require(shape.radius_m >= 0 && !shape.points.empty());
      marks.shapes.push_back(std::move(shape));
    }
    return marks;
  }

  shown::Network take(const Exhibit_Network& from) {
    shown::Network network;
    if (!fits(from.nodes(), 2000) || !fits(from.edges())) return network;
    for (const auto& node : from.nodes()) {
      network.nodes.push_back(
          {words(node.title()), {number(node.x()), number(node.y())}, number(node.value()), role(node.role())});
    }
    const auto count = static_cast<std::uint32_t>(from.nodes_size());
    for (const auto& edge : from.edges()) {
      if (!require(edge.from() < count && edge.to() < count)) return network;
      network.edges.push_back(
          {static_cast<int>(edge.from()), static_cast<int>(edge.to()), number(edge.weight()), role(edge.role())});
    }
    return network;
  }

 private:
  bool good_ = true;
};

}  // namespace

std::optional<shown::Exhibit> decode_exhibit(std::string_view bytes) {
  Exhibit message;
  const google::protobuf::LogSilencer silence;  // what is wrong with a file is told by whoever reads it
  if (bytes.size() > INT32_MAX || !message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
    return std::nullopt;
  }
  Taker taker;
  shown::Exhibit exhibit{taker.words(message.title()), shown::Frame{}};
  switch (message.form_case()) {
    case Exhibit::kFrame:
      exhibit.form = taker.take(message.frame());
      break;
    case Exhibit::kField:
      exhibit.form = taker.take(message.field());
      break;
    case Exhibit::kPatch:
      exhibit.form = taker.take(message.patch());
      break;
    case Exhibit::kCurve:
      exhibit.form = taker.take(message.curve());
      break;
    case Exhibit::kBars:
      exhibit.form = taker.take(message.bars());
      break;
    case Exhibit::kMarks:
      exhibit.form = taker.take(message.marks());
      break;
    case Exhibit::kNetwork:
      exhibit.form = taker.take(message.network());
      break;
    case Exhibit::FORM_NOT_SET:
      return std::nullopt;
  }
  if (!taker.good()) return std::nullopt;
  return exhibit;
}

}  // namespace ganglion
