#include "ganglion/record/exhibit/exhibit_json.h"

#include <fmt/format.h>

#include <cmath>

namespace ganglion {
namespace {

using Json = nlohmann::json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
/// To a tenth of a millimetre.
Json place(double value) { return number(std::round(value * 1e4) / 1e4); }
Json words(const Sentence& said) { return {{"en", said.en}, {"es", said.es}}; }
std::string named(Role role) { return std::string(look_of(role).name); }

Json axis_json(const shown::Axis& axis) {
  Json ticks = Json::array();
  for (const Sentence& tick : axis.ticks) ticks.push_back(words(tick));
  return {{"title", words(axis.title)}, {"unit", axis.unit}, {"ticks", std::move(ticks)}};
}

Json layer_json(const shown::Layer& layer) {
  Json classes = Json::array();
  for (const shown::Class& one : layer.classes) {
    classes.push_back({{"byte", layer.byte_of(one.value)}, {"role", named(one.role)}, {"title", words(one.title)}});
  }
  return {{"name", layer.name}, {"title", words(layer.title)}, {"unit", layer.unit},
          {"low", layer.low},   {"high", layer.high},          {"classes", std::move(classes)}};
}

Json form_json(const shown::Field& field) {
  Json layers = Json::array();
  for (const shown::Layer& layer : field.layers) layers.push_back(layer_json(layer));
  Json json = {
      {"frame", field.frame}, {"cell", {number(field.cell.x), number(field.cell.y)}}, {"layers", std::move(layers)}};
  if (field.across) json["across"] = axis_json(*field.across);
  if (field.up) json["up"] = axis_json(*field.up);
  return json;
}

Json form_json(const shown::Patch&) { return Json::object(); }

Json form_json(const shown::Frame& frame) {
  return {{"in", frame.in},
          {"x", number(frame.fixed.position.x)},
          {"y", number(frame.fixed.position.y)},
          {"yaw", number(frame.fixed.yaw.rad())},
          {"columns", {frame.x_m, frame.y_m, frame.yaw_rad}}};
}

Json form_json(const shown::Curve& curve) {
  Json lines = Json::array();
  for (const shown::Line& line : curve.lines) {
    Json xy = Json::array();
    for (std::size_t i = 0; i < line.x.size(); ++i) xy.insert(xy.end(), {number(line.x[i]), number(line.y[i])});
    lines.push_back({{"title", words(line.title)}, {"role", named(line.role)}, {"xy", std::move(xy)}});
  }
  return {{"across", axis_json(curve.across)},
          {"up", axis_json(curve.up)},
          {"lines", std::move(lines)},
          {"cursor", curve.cursor}};
}

Json form_json(const shown::Bars& bars) {
  Json list = Json::array();
  for (const shown::Bar& bar : bars.bars) {
    list.push_back({{"title", words(bar.title)}, {"value", number(bar.value)}, {"role", named(bar.role)}});
  }
  return {{"up", axis_json(bars.up)}, {"bars", std::move(list)}};
}

Json form_json(const shown::Marks& marks) {
  Json shapes = Json::array();
  for (const shown::Shape& shape : marks.shapes) shapes.push_back(json_of(shape));
  return {{"shapes", std::move(shapes)}};
}

Json form_json(const shown::Network& network) {
  Json nodes = Json::array(), edges = Json::array();
  for (const shown::Node& node : network.nodes) {
    nodes.push_back({{"title", words(node.title)},
                     {"x", number(node.place.x)},
                     {"y", number(node.place.y)},
                     {"value", number(node.value)},
                     {"role", named(node.role)}});
  }
  for (const shown::Edge& edge : network.edges) {
    edges.push_back(
        {{"from", edge.from}, {"to", edge.to}, {"weight", number(edge.weight)}, {"role", named(edge.role)}});
  }
  return {{"nodes", std::move(nodes)}, {"edges", std::move(edges)}};
}

}  // namespace

Json json_of(const shown::Shape& shape) {
  Json xy = Json::array();
  for (const Vector2 point : shape.points) xy.insert(xy.end(), {place(point.x), place(point.y)});
  Json json = {{"form", static_cast<int>(shape.form)},
               {"role", named(shape.role)},
               {"frame", shape.frame},
               {"xy", std::move(xy)}};
  if (!shape.id.empty()) json["id"] = shape.id;
  if (shape.radius_m > 0) json["radius"] = place(shape.radius_m);
  if (shape.angle_rad != 0) json["angle"] = place(shape.angle_rad);
  if (!shape.radius.empty()) json["column"] = shape.radius;
  if (!shape.label.empty()) json["label"] = words(shape.label);
  return json;
}

Json json_of(const shown::Exhibit& exhibit) {
  Json json = std::visit([](const auto& form) { return form_json(form); }, exhibit.form);
  json["title"] = words(exhibit.title);
  return json;
}

Json roles_json() {
  Json roles = Json::object();
  for (const RoleLook& look : role_looks()) {
    roles[std::string(look.name)] = {{"en", look.word.in(Language::English)},
                                     {"es", look.word.in(Language::Spanish)},
                                     {"light", fmt::format("#{:06x}", look.light)},
                                     {"dark", fmt::format("#{:06x}", look.dark)},
                                     {"dash", look.dash[0] > 0 ? Json(look.dash) : Json::array()},
                                     {"sign", name_of(look.sign)},
                                     {"filled", look.filled},
                                     {"over", look.over}};
  }
  return roles;
}

}  // namespace ganglion
