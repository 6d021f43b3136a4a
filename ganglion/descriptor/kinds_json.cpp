#include "ganglion/descriptor/kinds_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "ganglion/descriptor/common_parameters.h"
#include "ganglion/descriptor/json_schema.h"

namespace ganglion {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Text& text) { return {{"en", text.in(Language::English)}, {"es", text.in(Language::Spanish)}}; }

Json json_of(const PortDescriptor& port, ComponentClass component_class, bool common) {
  Json json = {{"name", port.name},
               {"direction", is_input(component_class, port.role) ? "in" : "out"},
               {"role", name_of(port.role)},
               {"unit", port.unit},
               {"type", name_of(port.type)},
               {"size", port.width()},
               {"elements", element_names(port)},
               {"required", is_input(component_class, port.role) && port.required},
               {"many", port.many},
               {"common", common},
               {"title", json_of(port.title)},
               {"help", json_of(port.help)}};
  if (port.standing) json["standing"] = true;
  if (port.each_candidate) json["each_candidate"] = true;
  if (port.derived) json["derived"] = true;
  return json;
}

Json limit_of(const ParameterDescriptor& parameter, double limit) {
  return parameter.type == ParameterType::Integer ? Json(static_cast<std::int64_t>(limit)) : Json(limit);
}

Json json_of(const ParameterDescriptor& parameter, bool common) {
  Json json = {{"name", parameter.name}, {"type", name_of(parameter.type)}, {"unit", parameter.unit}};
  json["default"] = preset_json(parameter);
  if (std::isfinite(parameter.min)) json["min"] = limit_of(parameter, parameter.min);
  if (std::isfinite(parameter.max)) json["max"] = limit_of(parameter, parameter.max);
  if (!parameter.allowed.empty()) json["allowed"] = parameter.allowed;
  if (parameter.type == ParameterType::Choice) json["choices"] = parameter.choices;
  if (parameter.type == ParameterType::Reals) json["count"] = parameter.count;
  json["ours"] = parameter.ours;
  json["live"] = parameter.live;
  json["common"] = common;
  json["title"] = json_of(parameter.title);
  json["help"] = json_of(parameter.help);
  return json;
}

Json json_of(const Descriptor& kind) {
  Json json = {{"class", name_of(kind.component_class)},
               {"name", kind.name},
               {"paper_name", kind.paper_name},
               {"summary", json_of(kind.summary)},
               {"source", kind.source},
               {"ports", Json::array()},
               {"parameters", Json::array()}};
  for (const PortDescriptor& port : kind.ports) json["ports"].push_back(json_of(port, kind.component_class, false));
  for (const PortDescriptor& port : common_outputs(kind)) {
    json["ports"].push_back(json_of(port, kind.component_class, true));
  }
  for (const ParameterDescriptor& parameter : kind.parameters) json["parameters"].push_back(json_of(parameter, false));
  for (const ParameterDescriptor& parameter : common_parameters(kind.component_class)) {
    json["parameters"].push_back(json_of(parameter, true));
  }
  return json;
}

}  // namespace

std::string kinds_json(std::span<const Descriptor* const> kinds) {
  Json list = Json::array();
  for (const Descriptor* kind : kinds) list.push_back(json_of(*kind));
  return list.dump(2) + "\n";
}

}  // namespace ganglion
