#include "ganglion/graph/schema.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "ganglion/descriptor/json_schema.h"
#include "ganglion/graph/model.h"

namespace ganglion {
namespace {

using Json = nlohmann::ordered_json;

Json reference(std::string_view name) { return {{"$ref", fmt::format("#/$defs/{}", name)}}; }

Json definitions() {
  Json wire = {
      {"type", "string"},
      {"pattern", "^[A-Za-z_][A-Za-z0-9_]*(\\.[^.@]+){0,2}(@previous)?$"},
      {"description", "A sensation, a module, \"module.output\", or with @previous the value of the tick before"}};
  Json wires = {{"anyOf", Json::array({reference("wire"),
                                       Json{{"type", "array"}, {"items", reference("wire")}, {"minItems", 1}}})}};
  return {{"id",
           {{"type", "string"},
            {"pattern", "^[A-Za-z_][A-Za-z0-9_]{0,63}$"},
            {"description", "Name of this component, used once in the file"}}},
          {"wire", std::move(wire)},
          {"wires", std::move(wires)}};
}

std::string description_of(const PortDescriptor& port) {
  std::string text(port.help.in(Language::English));
  if (!port.unit.empty() && port.unit != "*") text += fmt::format(" [{}]", port.unit);
  return text;
}

/// The `in` table of a kind; null where it has no inputs.
Json inputs_schema(const Descriptor& kind) {
  Json properties, required = Json::array();
  for (const PortDescriptor& port : kind.ports) {
    if (!is_input(kind.component_class, port.role)) continue;
    Json schema = reference(port.many || port.role == PortRole::Request ? "wires" : "wire");
    schema["description"] = description_of(port);
    properties[std::string(port.name)] = std::move(schema);
    if (port.required) required.push_back(port.name);
  }
  if (properties.is_null()) return {};
  return {{"type", "object"},
          {"properties", std::move(properties)},
          {"required", std::move(required)},
          {"additionalProperties", false}};
}

Json component_schema(const Descriptor& kind) {
  Json schema = kind_schema(kind);
  Json& properties = schema["properties"];
  properties["id"] = reference("id");
  schema["required"].push_back("id");
  Json inputs = inputs_schema(kind);
  if (!inputs.is_null()) {
    if (!inputs["required"].empty()) schema["required"].push_back("in");
    properties["in"] = std::move(inputs);
  }
  if (kind.component_class == ComponentClass::Acting || kind.component_class == ComponentClass::Coordinator) {
    properties["command"] = {{"type", "string"}, {"description", "The robot's command it drives"}};
  }
  return schema;
}

Json sensations_schema() {
  Json item = {
      {"type", "object"},
      {"properties",
       {{"id", reference("id")},
        {"channel", {{"type", "string"}, {"description", "As the robot describes it: \"sonar_left.range\""}}}}},
      {"required", Json::array({"id", "channel"})},
      {"additionalProperties", false}};
  return {{"type", "array"}, {"items", std::move(item)}};
}

}  // namespace

std::string controller_schema(const KindList& kinds) {
  Json properties = {
      {"format", {{"const", 1}, {"description", "Version of the file's format"}}},
      {"name", {{"type", "string"}, {"description", "Shown in reports"}}},
      {"robot", {{"type", "string"}, {"description", "The robot's description, a path relative to this file"}}},
      {"tick_s",
       {{"type", "number"},
        {"minimum", 0},
        {"maximum", 3600},
        {"default", 0},
        {"description", "The time step it was made for [s]; 0 = the robot's"}}},
      {"sensation", sensations_schema()}};
  for (const ComponentClass component_class :
       {ComponentClass::Sensing, ComponentClass::Goal, ComponentClass::Acting, ComponentClass::Coordinator}) {
    std::vector<Json> schemas;
    for (const Descriptor* kind : descriptors_of(kinds, component_class)) schemas.push_back(component_schema(*kind));
    properties[std::string(name_of(component_class))] = kinds_schema(schemas);
  }
  properties["layout"] = {{"type", "object"}, {"description", "Where the boxes of the drawing stand"}};
  const Json schema = {{"$schema", kJsonSchemaDialect},
                       {"title", "Ganglion controller"},
                       {"type", "object"},
                       {"properties", std::move(properties)},
                       {"required", Json::array({"format"})},
                       {"additionalProperties", false},
                       {"$defs", definitions()}};
  return schema.dump(2) + "\n";
}

}  // namespace ganglion
