#include "ganglion/config/source/sheet.h"

#include <algorithm>

namespace ganglion::config {

void Sheet::look() {
  map_ = map_source(text_);
  items_ = items_of(map_, text_, lists_);
  by_id_.clear();
  for (std::size_t i = 0; i < items_.size(); ++i) by_id_.try_emplace(items_[i].id, i);
}

const ItemSource* Sheet::find(std::string_view id) const {
  const auto found = id.empty() ? by_id_.end() : by_id_.find(std::string(id));
  return found != by_id_.end() ? &items_[found->second] : nullptr;
}

std::vector<std::string> Sheet::ids() const {
  std::vector<std::string> result;
  for (const ItemSource& item : items_) result.push_back(item.id);
  return result;
}

std::string Sheet::free_id(const std::string& wanted) const {
  if (!by_id_.contains(wanted)) return wanted;
  std::size_t letters = wanted.size();  // "avoid_2" goes on with "avoid_3"
  while (letters > 0 && wanted[letters - 1] >= '0' && wanted[letters - 1] <= '9') --letters;
  const bool numbered = letters > 1 && letters < wanted.size() && wanted[letters - 1] == '_';
  const std::string stem = numbered ? wanted.substr(0, letters - 1) : wanted;
  for (int number = 2;; ++number) {
    std::string id = fmt::format("{}_{}", stem, number);
    if (!by_id_.contains(id)) return id;
  }
}

std::optional<Sheet::Found> Sheet::member(std::string_view id, std::string_view key) const {
  if (id.empty()) {
    const MemberSource* found = map_.sections.front().member(key);
    return found != nullptr ? std::optional(Found{0, found}) : std::nullopt;
  }
  const ItemSource* item = find(id);
  if (item == nullptr) return std::nullopt;
  for (const std::size_t index : item->sections) {
    const std::string prefix = item->prefix(map_, index);
    if (!key.starts_with(prefix)) continue;
    if (const MemberSource* found = map_.sections[index].member(key.substr(prefix.size()))) return Found{index, found};
  }
  return std::nullopt;
}

std::vector<Sheet::Entry> Sheet::entries(std::string_view table) const {
  std::vector<Entry> result;
  const std::string before = std::string(table) + ".";
  for (const ItemSource& item : items_) {
    for (const std::size_t index : item.sections) {
      const std::string prefix = item.prefix(map_, index);
      for (const MemberSource& member : map_.sections[index].members) {
        const std::string key = prefix + member.key;
        if (key.starts_with(before)) result.push_back({&item, key.substr(before.size()), &member, index});
      }
    }
  }
  return result;
}

void Sheet::commit() {
  std::stable_sort(changes_.begin(), changes_.end(),
                   [](const Change& a, const Change& b) { return a.region.begin < b.region.begin; });
  std::string text;
  text.reserve(text_.size() + 256);
  std::size_t at = 0;
  for (const Change& change : changes_) {
    if (change.region.begin < at) continue;  // lies in what is gone already
    text.append(text_, at, change.region.begin - at);
    text += change.by;
    at = change.region.end;
  }
  text.append(text_, at);
  text_ = std::move(text);
  changes_.clear();
  look();
}

void Sheet::set(std::string_view id, const std::string& key, const std::string& toml) {
  if (const auto found = member(id, key)) {
    replace(found->member->value, toml);
    return;
  }
  const ItemSource* item = find(id);
  std::size_t section = 0;
  std::string rest = key;
  if (item != nullptr) {
    section = item->sections.front();
    for (const std::size_t index : item->sections) {  // [acting.in] takes in.left as left
      const std::string prefix = item->prefix(map_, index);
      if (prefix.empty() || !key.starts_with(prefix)) continue;
      section = index;
      rest = key.substr(prefix.size());
    }
  }
  const std::size_t at = map_.sections[section].body_end;
  const bool open_line = at > 0 && text_[at - 1] != '\n';
  insert(at, fmt::format("{}{} = {}\n", open_line ? "\n" : "", rest, toml));
}

void Sheet::erase(std::string_view, const Found& found) { replace(found.member->lines, ""); }

void Sheet::expand_inline(std::string_view id, std::string_view key) {
  const auto whole = member(id, key);
  if (!whole || !whole->member->inline_key.empty()) return;
  std::string lines;
  for (const MemberSource& member : map_.sections[whole->section].members) {
    if (member.inline_key != whole->member->key) continue;
    lines += fmt::format("{} = {}\n", member.key, member.value.of(text_));
  }
  if (lines.empty()) return;
  const std::string_view rest = Region{whole->member->value.end, whole->member->lines.end}.of(text_);
  if (const auto hash = rest.find('#'); hash != std::string_view::npos) {  // the comment behind it stays, on top
    lines.insert(0, fmt::format("{}\n", rest.substr(hash, rest.find('\n', hash) - hash)));
  }
  replace(whole->member->lines, lines);
  commit();
}

}  // namespace ganglion::config
