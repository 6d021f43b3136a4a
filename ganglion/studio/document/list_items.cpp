#include "ganglion/studio/document/list_items.h"

#include <algorithm>

namespace ganglion::studio {
namespace {

bool is_blank(char c) noexcept { return c == ' ' || c == '\t'; }

/// An item of a list with what belongs to it.
struct Item {
  config::Region text;
  config::Region above;   ///< The lines of comment directly above it; empty: where they would stand.
  config::Region behind;  ///< The comment behind it with the blanks before it; empty: where it would stand.
  bool first = false;     ///< Nothing stands before it on its line.
  bool last = false;      ///< Nothing but its comment stands behind it on its line.
  bool comma = false;
};

std::size_t line_begin(const std::string& text, std::size_t at) noexcept {
  const std::size_t end = at > 0 ? text.rfind('\n', at - 1) : std::string::npos;
  return end == std::string::npos ? 0 : end + 1;
}

/// Before the line end, a carriage return included.
std::size_t line_end(const std::string& text, std::size_t at) noexcept {
  const std::size_t end = std::min(text.find('\n', at), text.size());
  return end > at && text[end - 1] == '\r' ? end - 1 : end;
}

std::size_t past_blanks(const std::string& text, std::size_t at) noexcept {
  while (at < text.size() && is_blank(text[at])) ++at;
  return at;
}

/// Where the comments begin that stand on lines of their own directly above the line that begins there.
std::size_t comments_begin(const std::string& text, config::Region list, std::size_t line) noexcept {
  while (line > list.begin) {
    const std::size_t above = line_begin(text, line - 1);
    if (above <= list.begin || text[past_blanks(text, above)] != '#') return line;
    line = above;
  }
  return line;
}

Item item_at(const std::string& text, config::Region list, config::Region region) {
  Item item;
  item.text = region;
  const std::size_t line = line_begin(text, region.begin);
  item.first = line > list.begin && past_blanks(text, line) == region.begin;
  item.above = item.first ? config::Region{comments_begin(text, list, line), line} : config::Region{line, line};
  std::size_t at = past_blanks(text, region.end);
  item.comma = at < list.end && text[at] == ',';
  const std::size_t behind = item.comma ? at + 1 : region.end;
  at = past_blanks(text, behind);
  const std::size_t end = line_end(text, at);
  const bool comment = at < list.end && text[at] == '#';
  item.last = comment || (at == end && at < list.end);
  item.behind = {behind, comment ? end : behind};
  return item;
}

std::vector<Item> items_in(const std::string& text, config::Region list) {
  std::vector<Item> items;
  for (const config::Region& region : config::strings_in(text, list)) items.push_back(item_at(text, list, region));
  return items;
}

std::string indent_of(const std::string& text, const Item& item) {
  const std::size_t line = line_begin(text, item.text.begin);
  return text.substr(line, past_blanks(text, line) - line);
}

/// Whether what stands above the items is about each of them.
bool each_has_its_own(const std::vector<Item>& items) {
  const bool lines = std::all_of(items.begin(), items.end(), [](const Item& item) { return item.first; });
  return lines && std::any_of(items.begin() + 1, items.end(), [](const Item& item) { return item.above.size() > 0; });
}

}  // namespace

void put_in_order(config::Sheet& sheet, config::Region list, const std::vector<std::size_t>& order) {
  const std::string& text = sheet.text();
  const std::vector<Item> items = items_in(text, list);
  if (items.empty()) return;
  const bool above = each_has_its_own(items);
  for (std::size_t n = 0; n < items.size(); ++n) {
    const Item &place = items[n], &item = items[order[n]];
    if (order[n] == n) continue;
    if (above) sheet.replace(place.above, std::string(item.above.of(text)));
    sheet.replace(place.text, std::string(item.text.of(text)));
    std::string comment(item.behind.of(text));
    if (!comment.empty() && !place.last) comment += "\n" + indent_of(text, place);
    if (!comment.empty() || place.behind.size() > 0) sheet.replace(place.behind, std::move(comment));
  }
}

void put_in(config::Sheet& sheet, config::Region list, std::size_t index, const std::string& toml) {
  const std::string& text = sheet.text();
  const std::vector<Item> items = items_in(text, list);
  if (items.empty()) return sheet.insert(list.begin + 1, toml);
  if (index < items.size()) {
    const Item& next = items[index];
    const bool own_line = next.first && next.last;
    if (!own_line) return sheet.insert(next.text.begin, toml + ", ");
    const bool above = index > 0 || each_has_its_own(items);
    const std::size_t at = above ? next.above.begin : line_begin(text, next.text.begin);
    return sheet.insert(at, indent_of(text, next) + toml + ",\n");
  }
  const Item& before = items.back();
  if (!before.first || !before.last) return sheet.insert(before.text.end, ", " + toml);
  if (!before.comma) sheet.insert(before.text.end, ",");
  sheet.insert(before.behind.end, "\n" + indent_of(text, before) + toml + (before.comma ? "," : ""));
}

void take_out(config::Sheet& sheet, config::Region list, config::Region region) {
  const std::string& text = sheet.text();
  const Item item = item_at(text, list, region);
  if (item.first && item.last && item.behind.size() == 0) {
    const std::size_t end = text.find('\n', item.behind.end);
    return sheet.replace({line_begin(text, region.begin), end + 1}, "");
  }
  if (item.comma) return sheet.replace({region.begin, past_blanks(text, item.behind.begin)}, "");
  if (item.first) return sheet.replace(region, "");  // the comma before it may stay
  std::size_t begin = region.begin;
  while (begin > list.begin && (is_blank(text[begin - 1]) || text[begin - 1] == '\n' || text[begin - 1] == '\r'))
    --begin;
  const bool comma = begin > list.begin && text[begin - 1] == ',';
  sheet.replace({comma ? begin - 1 : region.begin, region.end}, "");
}

}  // namespace ganglion::studio
