#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "ganglion/base/text.h"
#include "ganglion/studio/document/component_lists.h"
#include "ganglion/studio/document/operations.h"

namespace ganglion::studio {
namespace {

std::size_t rank(std::string_view name) noexcept {
  return static_cast<std::size_t>(std::find(kComponentLists.begin(), kComponentLists.end(), name) -
                                  kComponentLists.begin());
}

/// Where a component of the class goes: behind the last of its class, or of those before it.
std::size_t place_for(const config::Sheet& sheet, std::string_view component_class) {
  std::size_t at = sheet.map().sections.front().body_end;
  for (const config::ItemSource& component : sheet.items()) {
    if (rank(component.list) > rank(component_class)) continue;
    for (const std::size_t index : component.sections) at = std::max(at, sheet.map().sections[index].body_end);
  }
  return at;
}

/// "DynamicMapRouter" -> "dynamic_map_router".
std::string id_from(std::string_view name) {
  std::string id;
  for (const char c : name) {
    const bool upper = c >= 'A' && c <= 'Z';
    const bool good = upper || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (upper && !id.empty() && id.back() != '_') id += '_';
    id += upper ? static_cast<char>(c - 'A' + 'a') : good ? c : '_';
  }
  if (id.empty() || (id[0] >= '0' && id[0] <= '9')) id.insert(0, "c");
  return id.substr(0, 60);
}

bool is_bare(std::string_view key) noexcept {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

/// The key of a set or unset: of a component any but its id and wires.
Result<std::string> key_in(const Json& what, std::string_view id) {
  auto key = text_in(what, "key");
  if (!key) return key;
  if (!is_bare(*key) || *key == "in" || *key == "layout" || (*key == "id" && !id.empty())) {
    return fail(ErrorCode::BadParameter, {"\"{}\" cannot be set so", "\"{}\" no se puede fijar así"}, *key);
  }
  return key;
}

Result<std::string> owner_in(const config::Sheet& sheet, const Json& what) {
  auto id = text_in(what, "id");
  if (!id || id->empty()) return id;
  const auto component = component_in(sheet, what);
  if (!component) return tl::unexpected<Error>(component.error());
  return id;
}

std::string separated(const config::Sheet& sheet, std::size_t at, const std::string& block) {
  const bool open_line = at > 0 && sheet.text()[at - 1] != '\n';
  return (open_line ? "\n\n" : "\n") + block;
}

}  // namespace

Result<std::string> position_of(const Json& value) {
  if (!value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_number()) {
    return fail(ErrorCode::BadType, {"a position must be [x, y]", "una posición debe ser [x, y]"});
  }
  const double x = value[0].get<double>(), y = value[1].get<double>();
  if (!(std::abs(x) < 1e9 && std::abs(y) < 1e9))
    return fail(ErrorCode::BadParameter, {"a position lies too far off", "una posición está demasiado lejos"});
  return fmt::format("[{}, {}]", std::lround(x), std::lround(y));
}

void place_boxes(config::Sheet& sheet, const std::vector<std::pair<std::string, std::string>>& positions) {
  const auto& sections = sheet.map().sections;
  const auto layout = std::find_if(sections.begin(), sections.end(), [](const config::SectionSource& section) {
    return section.name == "layout" && !section.list;
  });
  std::unordered_map<std::string_view, const config::MemberSource*> boxes;
  if (layout != sections.end()) {
    for (const config::MemberSource& box : layout->members) boxes.try_emplace(box.key, &box);
  }
  std::string fresh;
  for (const auto& [id, position] : positions) {
    const auto box = boxes.find(id);
    if (box != boxes.end()) {
      const std::string now(box->second->value.of(sheet.text()));
      if (Json::parse(now, nullptr, false) != Json::parse(position)) sheet.replace(box->second->value, position);
    } else {
      fresh += fmt::format("{} = {}\n", id, position);
    }
  }
  if (fresh.empty()) return;
  if (layout != sections.end()) {
    const bool open_line = layout->body_end > 0 && sheet.text()[layout->body_end - 1] != '\n';
    sheet.insert(layout->body_end, (open_line ? "\n" : "") + fresh);
  } else {
    sheet.insert(sheet.text().size(), separated(sheet, sheet.text().size(), "[layout]\n" + fresh));
  }
}

Result<void> add_component(config::Sheet& sheet, const Json& what, std::vector<std::string>& ids) {
  const auto component_class = text_in(what, "class");
  if (!component_class) return tl::unexpected<Error>(component_class.error());
  if (rank(*component_class) == kComponentLists.size()) {
    return fail(ErrorCode::UnknownKey, {"there is no class \"{}\"", "no existe la clase \"{}\""}, *component_class);
  }
  const bool sensation = *component_class == "sensation";
  std::string kind = sensation ? "" : what.value("kind", Json("")).is_string() ? what.value("kind", "") : "";
  const Json set = what.value("set", Json::object());
  if (!set.is_object()) return fail(ErrorCode::BadType, {"\"set\" must be an object", "\"set\" debe ser un objeto"});
  std::string wanted = id_from(kind);
  if (sensation && set.contains("channel") && set["channel"].is_string()) {
    wanted = id_from(set["channel"].get<std::string>());
  }
  if (what.contains("id")) {
    const auto given = text_in(what, "id");
    if (!given) return tl::unexpected<Error>(given.error());
    if (auto good = check_id(*given); !good) return good;
    if (!sheet.is_free(*given))
      return fail(ErrorCode::BadParameter, {"\"{}\" is the id of another", "\"{}\" es el id de otro componente"},
                  *given);
    wanted = *given;
  }
  const std::string id = sheet.free_id(wanted);
  std::string block = fmt::format("[[{}]]\nid = {}\n", *component_class, config::toml_text(id));
  if (!sensation) block += fmt::format("kind = {}\n", config::toml_text(kind));
  for (const auto& [key, value] : set.items()) {
    const auto toml = toml_of(value);
    if (!toml) return tl::unexpected<Error>(toml.error());
    if (!is_bare(key) || key == "id" || key == "kind" || key == "in") {
      return fail(ErrorCode::BadParameter, {"\"{}\" cannot be set so", "\"{}\" no se puede fijar así"}, key);
    }
    block += fmt::format("{} = {}\n", key, *toml);
  }
  if (what.contains("position")) {
    const auto position = position_of(what["position"]);
    if (!position) return tl::unexpected<Error>(position.error());
    place_boxes(sheet, {{id, *position}});
  }
  const std::size_t at = place_for(sheet, *component_class);
  sheet.insert(at, separated(sheet, at, block));
  ids.push_back(id);
  return {};
}

Result<void> set_member(config::Sheet& sheet, const Json& what, std::vector<std::string>&) {
  const auto id = owner_in(sheet, what);
  if (!id) return tl::unexpected<Error>(id.error());
  const auto key = key_in(what, *id);
  if (!key) return tl::unexpected<Error>(key.error());
  if (!what.contains("value")) return fail(ErrorCode::BadType, {"\"value\" is missing", "falta \"value\""});
  const auto toml = toml_of(what["value"]);
  if (!toml) return tl::unexpected<Error>(toml.error());
  sheet.set(*id, *key, *toml);
  return {};
}

Result<void> unset_member(config::Sheet& sheet, const Json& what, std::vector<std::string>&) {
  const auto id = owner_in(sheet, what);
  if (!id) return tl::unexpected<Error>(id.error());
  const auto key = key_in(what, *id);
  if (!key) return tl::unexpected<Error>(key.error());
  const auto found = sheet.member(*id, *key);
  if (!found) return fail(ErrorCode::UnknownKey, {"\"{}\" is not set", "\"{}\" no está fijado"}, *key);
  sheet.erase(*id, *found);
  return {};
}

Result<void> move(config::Sheet& sheet, const Json& what, std::vector<std::string>&) {
  const auto positions = what.find("positions");
  if (positions == what.end() || !positions->is_object()) {
    return fail(ErrorCode::BadType, {"\"positions\" must be an object", "\"positions\" debe ser un objeto"});
  }
  std::vector<std::pair<std::string, std::string>> boxes;
  for (const auto& [id, value] : positions->items()) {
    const auto component = component_in(sheet, Json{{"id", id}});
    if (!component) return tl::unexpected<Error>(component.error());
    const auto position = position_of(value);
    if (!position) return tl::unexpected<Error>(position.error());
    if (auto good = check_id(id); !good) return good;
    boxes.emplace_back(id, *position);
  }
  place_boxes(sheet, boxes);
  return {};
}

Result<std::string> copy(std::string_view text, const std::vector<std::string>& ids) {
  const config::Sheet sheet(std::string(text), kComponentLists);
  std::unordered_map<std::string_view, std::string> boxes;
  for (const config::SectionSource& section : sheet.map().sections) {
    if (section.name != "layout") continue;
    for (const config::MemberSource& box : section.members) boxes[box.key] += box.lines.of(sheet.text());
  }
  std::string result, layout;
  for (const std::string& id : ids) {
    const auto component = component_in(sheet, Json{{"id", id}});
    if (!component) return tl::unexpected<Error>(component.error());
    for (const std::size_t index : (*component)->sections) {
      const config::SectionSource& section = sheet.map().sections[index];
      result += fmt::format("{}{}", result.empty() ? "" : "\n",
                            config::Region{section.begin, section.body_end}.of(sheet.text()));
    }
    if (const auto box = boxes.find(id); box != boxes.end()) layout += box->second;
  }
  if (!layout.empty()) result += "\n[layout]\n" + layout;
  return result;
}

}  // namespace ganglion::studio
