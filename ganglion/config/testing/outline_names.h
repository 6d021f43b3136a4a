#pragma once

#include <algorithm>
#include <list>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "ganglion/config/outline.h"

/// Keys as "mover.id", those of a kind as "sensor.Sonar.max_range_m": to hold a reader and its schema side by side.
namespace ganglion::config {

using KeyNames = std::set<std::string>;

inline void gather(const std::list<Outline>& tables, const std::string& place, KeyNames& asked, KeyNames& mentioned) {
  for (const Outline& table : tables) {
    const std::string here = table.kind() != nullptr ? place + std::string(table.kind()->name) + "." : place;
    for (const std::string& name : table.mentioned()) mentioned.insert(here + name);
    for (const Outline::Key& key : table.keys()) {
      asked.insert(here + key.name);
      gather(key.asked.inside, here + key.name + ".", asked, mentioned);
      const bool table = !key.asked.inside.empty();
      const auto empty = [](const Outline& inside) { return inside.keys().empty(); };
      if (table && std::all_of(key.asked.inside.begin(), key.asked.inside.end(), empty)) {
        mentioned.insert(here + key.name + ".*");
      }
    }
  }
}

/// Whatever the reader asked in any of the samples.
inline KeyNames asked_keys(const std::list<Outline>& samples) {
  KeyNames asked, mentioned;
  gather(samples, "", asked, mentioned);
  return asked;
}

/// What the reader knows of, but was brought to ask by no sample: the samples lack a form. "battery.*" is a table that
/// it opened and asked nothing of.
inline KeyNames unasked_keys(const std::list<Outline>& samples) {
  KeyNames asked, mentioned;
  gather(samples, "", asked, mentioned);
  for (const std::string& name : asked) mentioned.erase(name);
  return mentioned;
}

inline void gather(const nlohmann::json& schema, const std::string& place, KeyNames& names) {
  if (!schema.is_object()) return;
  const std::string here = !place.empty() && schema.contains("title") && schema.contains("properties")
                               ? place + schema["title"].get<std::string>() + "."
                               : place;
  if (schema.contains("items")) gather(schema["items"], here, names);
  if (schema.contains("oneOf")) {
    for (const auto& option : schema["oneOf"]) gather(option, here, names);
  }
  if (!schema.contains("properties")) return;
  for (const auto& [name, inside] : schema["properties"].items()) {
    names.insert(here + name);
    gather(inside, here + name + ".", names);
  }
}

/// Whatever a schema has as a property.
inline KeyNames schema_keys(const nlohmann::json& schema) {
  KeyNames names;
  gather(schema, "", names);
  return names;
}

}  // namespace ganglion::config
