#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>

#include "ganglion/config/value.h"

namespace ganglion::config {

inline nlohmann::json json_of(const Value& value) {
  if (const auto* v = value.boolean()) return *v;
  if (const auto* v = value.integer()) return *v;
  if (const auto* v = value.real()) return *v;
  if (const auto* v = value.string()) return *v;
  if (const auto* items = value.array()) {
    nlohmann::json list = nlohmann::json::array();
    for (const Value& item : *items) list.push_back(json_of(item));
    return list;
  }
  nlohmann::json object = nlohmann::json::object();
  for (const auto& [key, member] : *value.table()) object[key] = json_of(member);
  return object;
}

/// The part of JSON Schema that our schemas use, after the specification; any other keyword is a failure.
class SchemaValidator {
 public:
  using Json = nlohmann::json;

  explicit SchemaValidator(const Json& root) : root_(root) {}

  bool accepts(const Json& schema, const Json& value) const {
    if (schema.is_boolean()) return schema.get<bool>();
    for (const auto& [keyword, wanted] : schema.items()) {
      if (!holds(keyword, wanted, schema, value)) return false;
    }
    return true;
  }

 private:
  bool holds(const std::string& keyword, const Json& wanted, const Json& schema, const Json& value) const {
    const auto accepted = [&](const Json& option) { return accepts(option, value); };
    if (keyword == "$ref") return accepts(root_["$defs"][wanted.get<std::string>().substr(8)], value);
    if (keyword == "type") return is(wanted, value);
    if (keyword == "const") return value == wanted;
    if (keyword == "enum") return std::count(wanted.begin(), wanted.end(), value) > 0;
    if (keyword == "minimum") return !value.is_number() || value >= wanted;
    if (keyword == "exclusiveMinimum") return !value.is_number() || value > wanted;
    if (keyword == "maximum") return !value.is_number() || value <= wanted;
    if (keyword == "minItems") return !value.is_array() || value.size() >= wanted;
    if (keyword == "maxItems") return !value.is_array() || value.size() <= wanted;
    if (keyword == "oneOf") return std::count_if(wanted.begin(), wanted.end(), accepted) == 1;
    if (keyword == "anyOf") return std::any_of(wanted.begin(), wanted.end(), accepted);
    if (keyword == "pattern") {
      return !value.is_string() || std::regex_search(value.get<std::string>(), std::regex(wanted.get<std::string>()));
    }
    if (keyword == "items") {
      return !value.is_array() ||
             std::all_of(value.begin(), value.end(), [&](const Json& item) { return accepts(wanted, item); });
    }
    if (keyword == "required") {
      return !value.is_object() ||
             std::all_of(wanted.begin(), wanted.end(), [&](const Json& key) { return value.contains(key); });
    }
    if (keyword == "properties" || keyword == "additionalProperties")
      return !value.is_object() || members(schema, value);
    static const std::set<std::string> kNotes = {"$schema", "$defs", "title", "description", "default"};
    EXPECT_TRUE(kNotes.contains(keyword)) << keyword;
    return true;
  }

  bool members(const Json& schema, const Json& value) const {
    for (const auto& [key, member] : value.items()) {
      if (schema["properties"].contains(key)) {
        if (!accepts(schema["properties"][key], member)) return false;
      } else if (schema.contains("additionalProperties")) {
        return false;
      }
    }
    return true;
  }

  static bool is(const std::string& type, const Json& value) {
    if (type == "integer") return value.is_number_integer();
    if (type == "number") return value.is_number();
    if (type == "object") return value.is_object();
    return type == value.type_name();
  }

  const Json& root_;
};

/// Whether a TOML text satisfies a schema.
inline bool schema_accepts(const nlohmann::json& schema, const std::string& text) {
  const auto value = parse(text, "sample.toml");
  EXPECT_TRUE(value) << text;
  return value && SchemaValidator(schema).accepts(schema, json_of(*value));
}

}  // namespace ganglion::config
