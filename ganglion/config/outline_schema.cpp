#include "ganglion/config/outline_schema.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ganglion/base/expects.h"
#include "ganglion/descriptor/json_schema.h"

namespace ganglion::config {
namespace {

using Json = nlohmann::ordered_json;
using Form = Asked::Form;
using Tables = std::vector<const Outline*>;
using Names = std::vector<std::string>;

bool contains(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Json table_schema(const Tables& tables);

bool requires_something(const Outline& table);

/// Also a table is, without which keys that it must have are missing.
bool needed(const Asked& asked) {
  return asked.required ||
         (asked.form == Form::Table && std::any_of(asked.inside.begin(), asked.inside.end(), requires_something));
}

bool requires_something(const Outline& table) {
  return std::any_of(table.keys().begin(), table.keys().end(),
                     [](const Outline::Key& key) { return needed(key.asked); });
}

/// What holds of a key in every sample: limits, choices and defaults that they do not share are left out.
Asked common(const std::vector<const Asked*>& samples) {
  const Asked& first = *samples.front();
  Asked result = {.form = first.form,
                  .range = first.range,
                  .least = first.least,
                  .most = first.most,
                  .choices = first.choices,
                  .preset = first.preset,
                  .parameter = first.parameter};
  for (const Asked* sample : samples) {
    expects(sample->form == result.form && sample->parameter == result.parameter);
    if (sample->range.min != result.range.min || sample->range.above_min != result.range.above_min) {
      result.range = {Range{}.min, result.range.max};
    }
    if (sample->range.max != result.range.max) result.range.max = Range{}.max;
    if (sample->least != result.least) result.least = 0;
    if (sample->most != result.most) result.most = 0;
    if (sample->choices != result.choices) result.choices.clear();
    if (sample->preset != result.preset) result.preset = {};
  }
  return result;
}

Json number_schema(const Range& range, bool whole) {
  if (whole && range.min == range.max) return {{"const", static_cast<std::int64_t>(range.min)}};
  const auto limit = [&](double value) { return whole ? Json(static_cast<std::int64_t>(value)) : Json(value); };
  Json json = {{"type", whole ? "integer" : "number"}};
  if (std::isfinite(range.min)) json[range.above_min ? "exclusiveMinimum" : "minimum"] = limit(range.min);
  if (std::isfinite(range.max)) json["maximum"] = limit(range.max);
  return json;
}

Json list_schema(Json items, const Asked& asked) {
  Json json = {{"type", "array"}, {"items", std::move(items)}};
  if (asked.least != 0) json["minItems"] = asked.least;
  if (asked.most != 0) json["maxItems"] = asked.most;
  return json;
}

Json point_schema(const Range& coordinate) {
  return list_schema(number_schema(coordinate, false), {.least = 2, .most = 2});
}

Json type_schema(const Asked& asked) {
  switch (asked.form) {
    case Form::Number:
    case Form::Whole:
      return number_schema(asked.range, asked.form == Form::Whole);
    case Form::Boolean:
      return {{"type", "boolean"}};
    case Form::Choice:
      return {{"enum", asked.choices}};
    case Form::Numbers:
      return list_schema(number_schema(asked.range, false), asked);
    case Form::Points:
      return list_schema(point_schema(asked.range), asked);
    case Form::Texts:
      return {{"anyOf", Json::array({{{"type", "string"}}, list_schema({{"type", "string"}}, asked)})}};
    default:
      return {{"type", "string"}};
  }
}

/// Null where there is none worth telling: an empty text, NaN, an unlimited number.
Json preset_json(const Asked& asked) {
  if (const auto* value = std::get_if<bool>(&asked.preset)) return *value;
  if (const auto* value = std::get_if<double>(&asked.preset); value != nullptr && std::isfinite(*value)) {
    return asked.form == Form::Whole ? Json(static_cast<std::int64_t>(*value)) : Json(*value);
  }
  if (const auto* value = std::get_if<std::string>(&asked.preset); value != nullptr && !value->empty()) return *value;
  if (const auto* value = std::get_if<std::vector<double>>(&asked.preset); value != nullptr && !value->empty()) {
    return *value;
  }
  return {};
}

Json same_form_schema(const std::vector<const Asked*>& samples) {
  const Asked asked = common(samples);
  if (asked.parameter != nullptr) return parameter_schema(*asked.parameter);
  if (asked.form == Form::Table || asked.form == Form::Tables) {
    Tables inside;
    for (const Asked* sample : samples) {
      for (const Outline& table : sample->inside) inside.push_back(&table);
    }
    return asked.form == Form::Table ? table_schema(inside) : list_schema(table_schema(inside), {});
  }
  Json json = type_schema(asked);
  if (Json preset = preset_json(asked); !preset.is_null()) json["default"] = std::move(preset);
  return json;
}

/// Where it may be written in several forms, a number or a list of them, it is any of these.
Json key_schema(const std::vector<const Asked*>& samples) {
  std::vector<std::vector<const Asked*>> forms;
  for (const Asked* sample : samples) {
    const auto same = [&](const auto& form) { return form.front()->form == sample->form; };
    const auto form = std::find_if(forms.begin(), forms.end(), same);
    if (form == forms.end()) {
      forms.push_back({sample});
    } else {
      form->push_back(sample);
    }
  }
  if (forms.size() == 1) return same_form_schema(samples);
  Json json = {{"anyOf", Json::array()}};
  for (const auto& form : forms) json["anyOf"].push_back(same_form_schema(form));
  return json;
}

Names all_keys(const Tables& tables) {
  Names names;
  for (const Outline* table : tables) {
    for (const auto& key : table->keys()) {
      if (!contains(names, key.name)) names.push_back(key.name);
    }
  }
  return names;
}

Names needed_keys(const Outline& table) {
  Names names;
  for (const auto& key : table.keys()) {
    if (needed(key.asked)) names.push_back(key.name);
  }
  return names;
}

/// What one form of the table requires beyond what all do, and which keys of the other forms it bars.
Json form_schema(const Outline& table, const Names& keys, const Names& required) {
  Json json = Json::object();
  for (const std::string& name : needed_keys(table)) {
    if (!contains(required, name)) json["required"].push_back(name);
  }
  for (const std::string& name : keys) {
    if (table.find(name) == nullptr) json["properties"][name] = false;
  }
  return json;
}

Names needed_by_all(const Tables& tables) {
  Names names = needed_keys(*tables.front());
  std::erase_if(names, [&](const std::string& name) {
    return !std::all_of(tables.begin(), tables.end(),
                        [&](const Outline* table) { return contains(needed_keys(*table), name); });
  });
  return names;
}

/// Of tables of one kind, or of none.
Json plain_schema(const Tables& tables) {
  Json json = {{"type", "object"}, {"properties", Json::object()}};
  const Descriptor* kind = tables.front()->kind();
  const Json described = kind != nullptr ? kind_schema(*kind) : Json::object();
  if (kind != nullptr)
    json = {{"title", kind->name}, {"description", kind->summary.in(Language::English)}, {"type", "object"}};
  const Names keys = all_keys(tables);
  for (const std::string& name : keys) {
    std::vector<const Asked*> samples;
    for (const Outline* table : tables) {
      if (const Asked* asked = table->find(name)) samples.push_back(asked);
    }
    const bool names_kind = kind != nullptr && name == "kind";
    json["properties"][name] = names_kind ? described["properties"]["kind"] : key_schema(samples);
  }
  const Names required = needed_by_all(tables);
  if (!required.empty()) json["required"] = required;
  json["additionalProperties"] = false;
  Json forms = Json::array();
  for (const Outline* table : tables) {
    Json form = form_schema(*table, keys, required);
    if (std::find(forms.begin(), forms.end(), form) == forms.end()) forms.push_back(std::move(form));
  }
  if (forms.size() > 1) json["anyOf"] = std::move(forms);
  return json;
}

Json table_schema(const Tables& tables) {
  std::vector<Tables> kinds;
  for (const Outline* table : tables) {
    const auto same = [&](const Tables& group) { return group.front()->kind() == table->kind(); };
    const auto group = std::find_if(kinds.begin(), kinds.end(), same);
    if (group != kinds.end()) {
      group->push_back(table);
    } else {
      kinds.push_back({table});
    }
  }
  expects(!kinds.empty());
  if (kinds.size() == 1) return plain_schema(kinds.front());
  Json schemas = Json::array();
  for (const Tables& group : kinds) schemas.push_back(plain_schema(group));
  return {{"oneOf", std::move(schemas)}};
}

Tables pointers(const std::list<Outline>& samples) {
  Tables tables;
  for (const Outline& sample : samples) tables.push_back(&sample);
  return tables;
}

}  // namespace

Json table_schema(const std::list<Outline>& samples) { return table_schema(pointers(samples)); }

std::string schema_text(std::string_view title, const std::list<Outline>& samples) {
  Json schema = {{"$schema", kJsonSchemaDialect}, {"title", title}};
  schema.update(table_schema(samples));
  return schema.dump(2) + "\n";
}

}  // namespace ganglion::config
