#include "ganglion/descriptor/json_schema.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace ganglion {
namespace {

using Json = nlohmann::ordered_json;

std::string description_of(const ParameterDescriptor& parameter) {
  std::string text(parameter.help.in(Language::English));
  if (!parameter.unit.empty()) text += fmt::format(" [{}]", parameter.unit);
  if (parameter.ours) text += " Ours: not given by the source.";
  return text;
}

Json number_schema(const ParameterDescriptor& parameter, bool whole) {
  // Limits of a whole number are written as one: 1, not 1.0.
  const auto limit = [&](double value) { return whole ? Json(static_cast<std::int64_t>(value)) : Json(value); };
  Json json = {{"type", whole ? "integer" : "number"}};
  if (std::isfinite(parameter.min)) json["minimum"] = limit(parameter.min);
  if (std::isfinite(parameter.max)) json["maximum"] = limit(parameter.max);
  return json;
}

}  // namespace

Json parameter_schema(const ParameterDescriptor& parameter) {
  Json json;
  switch (parameter.type) {
    case ParameterType::Real:
      json = number_schema(parameter, false);
      json["default"] = parameter.preset;
      break;
    case ParameterType::Integer:
      json = number_schema(parameter, true);
      json["default"] = static_cast<std::int64_t>(parameter.preset);
      break;
    case ParameterType::Boolean:
      json = {{"type", "boolean"}, {"default", parameter.preset != 0}};
      break;
    case ParameterType::Choice:
      json = {{"enum", parameter.choices}, {"default", parameter.choices[static_cast<std::size_t>(parameter.preset)]}};
      break;
    case ParameterType::Word:
      json = {{"type", "string"}, {"default", parameter.preset_word}};
      break;
    case ParameterType::Reals:
      json = {{"type", "array"}, {"items", number_schema(parameter, false)}};
      if (parameter.count != 0) json["minItems"] = json["maxItems"] = parameter.count;
      json["default"] = parameter.preset_reals;
      break;
  }
  json["description"] = description_of(parameter);
  return json;
}

Json kind_schema(const Descriptor& kind) {
  Json names = Json::array({kind.name});
  if (!kind.paper_name.empty()) names.push_back(kind.paper_name);
  Json properties;
  properties["kind"] = names.size() == 1 ? Json{{"const", kind.name}} : Json{{"enum", names}};
  for (const ParameterDescriptor& parameter : kind.parameters) {
    properties[std::string(parameter.name)] = parameter_schema(parameter);
  }
  return {{"title", kind.name},
          {"description", kind.summary.in(Language::English)},
          {"type", "object"},
          {"properties", std::move(properties)},
          {"required", Json::array({"kind"})},
          {"additionalProperties", false}};
}

Json kinds_schema(const std::vector<Json>& kinds) {
  Json json = {{"type", "array"}};
  if (kinds.empty()) {
    json["maxItems"] = 0;
  } else {
    json["items"] = {{"oneOf", kinds}};
  }
  return json;
}

}  // namespace ganglion
