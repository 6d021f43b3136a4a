#include "ganglion/config/source/sheet.h"

#include <algorithm>

#include "ganglion/config/value.h"

namespace ganglion::config {
namespace {

/// The same to whoever reads the file: 0.10 is 0.1, and 1 is 1.0.
bool same(const Value& a, const Value& b) {
  const auto number = [](const Value& value) -> std::optional<double> {
    if (value.integer() != nullptr) return static_cast<double>(*value.integer());
    return value.real() != nullptr ? std::optional(*value.real()) : std::nullopt;
  };
  if (number(a) && number(b)) return *number(a) == *number(b);
  if (a.array() == nullptr || b.array() == nullptr) return equal(a, b);
  return std::equal(a.array()->begin(), a.array()->end(), b.array()->begin(), b.array()->end(),
                    [](const Value& one, const Value& other) { return same(one, other); });
}

bool same_toml(std::string_view a, std::string_view b) {
  const auto read = [](std::string_view toml) { return parse("v = " + std::string(toml), ""); };
  const auto one = read(a), other = read(b);
  return one && other && one->find("v") != nullptr && other->find("v") != nullptr &&
         same(*one->find("v"), *other->find("v"));
}

/// With a carriage return before every line feed that has none.
std::string with_returns(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n' && (i == 0 || text[i - 1] != '\r')) result += '\r';
    result += text[i];
  }
  return result;
}

bool is_blank(char c) noexcept { return c == ' ' || c == '\t'; }

}  // namespace

Sheet::Sheet(std::string text, std::span<const std::string_view> lists) : text_(std::move(text)), lists_(lists) {
  const std::size_t end = text_.find('\n');
  crlf_ = end != std::string::npos && end > 0 && text_[end - 1] == '\r';
  look();
}

Region Sheet::key_of(const MemberSource& member) const noexcept {
  std::size_t begin = member.lines.begin, end = member.value.begin;
  while (begin < end && is_blank(text_[begin])) ++begin;
  while (end > begin && is_blank(text_[end - 1])) --end;
  if (end > begin && text_[end - 1] == '=') --end;
  while (end > begin && is_blank(text_[end - 1])) --end;
  return {begin, end};
}

/// As its last line of its own is indented.
std::string Sheet::indent_of(const SectionSource& section) const {
  if (section.members.empty()) return "";
  const std::size_t begin = section.members.back().lines.begin;
  std::size_t end = begin;
  while (end < text_.size() && is_blank(text_[end])) ++end;
  return text_.substr(begin, end - begin);
}

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
    if (change.region.begin < at) {  // begins in what is gone already
      at = std::max(at, change.region.end);
      continue;
    }
    text.append(text_, at, change.region.begin - at);
    text += crlf_ ? with_returns(change.by) : change.by;
    at = change.region.end;
  }
  text.append(text_, at);
  text_ = std::move(text);
  changes_.clear();
  look();
}

void Sheet::set(std::string_view id, const std::string& key, const std::string& toml) {
  if (const auto found = member(id, key)) {
    const Region value = found->member->value;
    if (!same_toml(value.of(text_), toml)) replace(value, toml);
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
  insert(at, fmt::format("{}{}{} = {}\n", open_line ? "\n" : "", indent_of(map_.sections[section]), rest, toml));
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
