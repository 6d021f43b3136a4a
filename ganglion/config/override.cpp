#include "ganglion/base/text.h"
#include "ganglion/config/value.h"

namespace ganglion::config {
namespace {

/// The value with the place of everything in it set to the command line.
Value placed(const Value& value, const Place& place) {
  if (const auto* v = value.boolean()) return Value(*v, place);
  if (const auto* v = value.integer()) return Value(*v, place);
  if (const auto* v = value.real()) return Value(*v, place);
  if (const auto* v = value.string()) return Value(*v, place);
  if (const auto* items = value.array()) {
    Array copy;
    for (const Value& item : *items) copy.push_back(placed(item, place));
    return Value(std::move(copy), place);
  }
  Members copy;
  for (const auto& [key, member] : *value.table()) copy.emplace_back(key, placed(member, place));
  return Value(std::move(copy), place);
}

Value read_value(const std::string& text, const Place& place) {
  if (const auto parsed = parse("value = " + text, "--set"); parsed && parsed->table()->size() == 1) {
    return placed(parsed->table()->front().second, place);
  }
  return Value(text, place);
}

Value* item_by_id(Array& items, const std::string& id) {
  for (Value& item : items) {
    const Value* found = item.find("id");
    if (found != nullptr && found->string() != nullptr && *found->string() == id) return &item;
  }
  return nullptr;
}

std::vector<std::string> ids_of(const Array& items) {
  std::vector<std::string> ids;
  for (const Value& item : items) {
    if (const Value* id = item.find("id"); id != nullptr && id->string() != nullptr) ids.push_back(*id->string());
  }
  return ids;
}

/// The member `key` of a table, made where it is missing; or the item of that id in a list.
Result<Value*> descend(Value& from, const std::string& key, const Place& place) {
  if (Members* members = from.table()) {
    if (Value* found = from.find(key)) return found;
    members->emplace_back(key, Value(Members{}, place));
    return &members->back().second;
  }
  if (Array* items = from.array()) {
    if (Value* found = item_by_id(*items, key)) return found;
    return fail_at(place, ErrorCode::UnknownKey,
                   {"no item here has the id \"{}\"{}", "ningún elemento de aquí tiene el id \"{}\"{}"}, key,
                   suggestion(key, ids_of(*items)));
  }
  return fail_at(
      place, ErrorCode::BadType,
      {"\"{}\" lies behind a value that is {}, not a table", "\"{}\" está detrás de un valor que es {}, no una tabla"},
      key, from.type_name());
}

}  // namespace

Result<Override> parse_override(std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::string_view path = trimmed(text.substr(0, equals));
  if (equals == std::string_view::npos || path.empty()) {
    return fail(ErrorCode::Syntax,
                {"--set {}: write key=value, as in run.duration_s=60",
                 "--set {}: escriba clave=valor, como en run.duration_s=60"},
                text);
  }
  return Override{std::string(path), std::string(trimmed(text.substr(equals + 1)))};
}

Result<void> apply(Value& root, const Override& override) {
  const Place place{"--set " + override.path + "=" + override.value};
  Value* at = &root;
  for (const std::string& key : split(override.path, '.')) {
    if (key.empty())
      return fail_at(place, ErrorCode::Syntax, {"an empty name in the path", "un nombre vacío en la ruta"});
    const auto next = descend(*at, key, place);
    if (!next) return tl::unexpected<Error>(next.error());
    at = *next;
  }
  *at = read_value(override.value, place);
  return {};
}

}  // namespace ganglion::config
