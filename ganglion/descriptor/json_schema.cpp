#include "ganglion/descriptor/json_schema.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "ganglion/descriptor/common_parameters.h"

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

Json type_schema(const ParameterDescriptor& parameter) {
  switch (parameter.type) {
    case ParameterType::Real:
      return number_schema(parameter, false);
    case ParameterType::Integer:
      return number_schema(parameter, true);
    case ParameterType::Boolean:
      return {{"type", "boolean"}};
    case ParameterType::Choice:
      return {{"enum", parameter.choices}};
    case ParameterType::Word:
    case ParameterType::File:
      return {{"type", "string"}};
    case ParameterType::Reals:
      break;
  }
  Json list = {{"type", "array"}, {"items", number_schema(parameter, false)}};
  if (parameter.count != 0) {
    list["minItems"] = list["maxItems"] = parameter.count;
    return list;
  }
  return {{"anyOf", Json::array({number_schema(parameter, false), list})}};
}

}  // namespace

Json preset_json(const ParameterDescriptor& parameter) {
  const ParameterValue preset = parameter.preset();
  if (const auto* word = std::get_if<std::string>(&preset)) return *word;
  if (const auto* file = std::get_if<FileText>(&preset)) return file->name;
  if (const auto* numbers = std::get_if<std::vector<double>>(&preset)) return *numbers;
  const double number = std::get<double>(preset);
  if (parameter.type == ParameterType::Boolean) return number != 0;
  if (parameter.type == ParameterType::Integer) return static_cast<std::int64_t>(number);
  if (parameter.type == ParameterType::Choice) return parameter.choices[static_cast<std::size_t>(number)];
  return number;
}

Json parameter_schema(const ParameterDescriptor& parameter) {
  Json json = type_schema(parameter);
  if (!parameter.allowed.empty()) {
    json["enum"] = Json::array();
    for (const double value : parameter.allowed) {
      json["enum"].push_back(parameter.type == ParameterType::Integer ? Json(static_cast<std::int64_t>(value))
                                                                      : Json(value));
    }
  }
  json["default"] = preset_json(parameter);
  json["description"] = description_of(parameter);
  return json;
}

Json kind_schema(const Descriptor& kind) {
  Json names = Json::array({kind.name});
  if (!kind.paper_name.empty()) names.push_back(kind.paper_name);
  Json properties;
  properties["kind"] = names.size() == 1 ? Json{{"const", kind.name}} : Json{{"enum", names}};
  for (const auto& list : {kind.parameters, common_parameters(kind.component_class)}) {
    for (const ParameterDescriptor& parameter : list) {
      properties[std::string(parameter.name)] = parameter_schema(parameter);
    }
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
