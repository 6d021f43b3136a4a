#include <map>
#include <set>

#include "ganglion/config/value.h"
#include "ganglion/studio/document/component_lists.h"
#include "ganglion/studio/document/operations.h"

namespace ganglion::studio {
namespace {

/// The pasted components, renamed where their ids are taken; wires among them follow.
Result<config::Sheet> renamed(const config::Sheet& sheet, const std::string& toml, std::vector<std::string>& ids) {
  config::Sheet pasted(toml, kComponentLists);
  std::map<std::string, std::string> names;
  std::set<std::string> taken;
  for (const std::string& id : sheet.ids()) taken.insert(id);
  for (const std::string& id : pasted.ids()) {
    if (auto good = check_id(id); !good) return tl::unexpected<Error>(good.error());
    if (names.contains(id))
      return fail(ErrorCode::BadParameter, {"\"{}\" comes twice", "\"{}\" aparece dos veces"}, id);
    std::string free = sheet.free_id(id);
    while (taken.contains(free)) free += "_2";
    taken.insert(free);
    names[id] = free;
    ids.push_back(free);
  }
  const std::string text = pasted.text();
  for (const auto& [id, name] : names) {
    if (id != name) pasted.set(id, "id", config::toml_text(name));
  }
  for (const config::Sheet::Entry& input : pasted.entries("in")) {
    for (const config::Region& item : config::strings_in(text, input.member->value)) {
      const std::string wire = config::unquoted(item.of(text));
      const std::size_t end = std::min(wire.find_first_of(".@"), wire.size());
      const auto found = names.find(wire.substr(0, end));
      if (found != names.end()) pasted.replace(item, config::toml_text(found->second + wire.substr(end)));
    }
  }
  for (const config::SectionSource& section : pasted.map().sections) {
    if (section.name != "layout" || section.list) continue;
    for (const config::MemberSource& box : section.members) {
      const auto found = names.find(box.key);
      if (found != names.end()) {
        pasted.replace(box.lines, fmt::format("{} = {}\n", found->second, box.value.of(text)));
      }
    }
  }
  pasted.commit();
  return pasted;
}

double shift_of(const Json& what, std::size_t axis) {
  const auto offset = what.find("offset");
  if (offset == what.end() || !offset->is_array() || offset->size() != 2 || !(*offset)[axis].is_number()) return 0;
  return (*offset)[axis].get<double>();
}

Result<std::vector<std::pair<std::string, std::string>>> boxes_of(const config::Sheet& pasted, const Json& what) {
  std::vector<std::pair<std::string, std::string>> boxes;
  for (const config::SectionSource& section : pasted.map().sections) {
    if (section.name != "layout" || section.list) continue;
    for (const config::MemberSource& box : section.members) {
      const Json at = Json::parse(box.value.of(pasted.text()), nullptr, false);
      if (!at.is_array() || at.size() != 2 || !at[0].is_number() || !at[1].is_number()) continue;
      if (pasted.find(box.key) == nullptr) continue;
      const auto position =
          position_of({at[0].get<double>() + shift_of(what, 0), at[1].get<double>() + shift_of(what, 1)});
      if (!position) return tl::unexpected<Error>(position.error());
      boxes.emplace_back(box.key, *position);
    }
  }
  return boxes;
}

}  // namespace

Result<void> paste(config::Sheet& sheet, const Json& what, std::vector<std::string>& ids) {
  const auto toml = text_in(what, "toml");
  if (!toml) return tl::unexpected<Error>(toml.error());
  if (auto read = config::parse(*toml, "the pasted text"); !read) return tl::unexpected<Error>(read.error());
  std::vector<std::string> made;
  const auto pasted = renamed(sheet, *toml, made);
  if (!pasted) return tl::unexpected<Error>(pasted.error());
  if (made.empty())
    return fail(ErrorCode::BadParameter,
                {"the pasted text holds no component", "el texto pegado no contiene ningún componente"});
  const auto boxes = boxes_of(*pasted, what);
  if (!boxes) return tl::unexpected<Error>(boxes.error());
  std::size_t at = sheet.map().sections.front().body_end;
  for (const config::ItemSource& component : sheet.items()) {
    for (const std::size_t index : component.sections) at = std::max(at, sheet.map().sections[index].body_end);
  }
  std::string block = at > 0 && sheet.text()[at - 1] != '\n' ? "\n" : "";
  for (const config::ItemSource& component : pasted->items()) {
    for (const std::size_t index : component.sections) {
      const config::SectionSource& section = pasted->map().sections[index];
      block += fmt::format("\n{}", config::Region{section.begin, section.body_end}.of(pasted->text()));
      if (block.back() != '\n') block += '\n';
    }
  }
  place_boxes(sheet, *boxes);
  sheet.insert(at, block);
  ids.insert(ids.end(), made.begin(), made.end());
  return {};
}

}  // namespace ganglion::studio
