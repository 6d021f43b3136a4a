#include "ganglion/config/source/source_map.h"

#include <algorithm>

#include "ganglion/base/text.h"
#include "ganglion/config/lexer.h"
#include "ganglion/config/value.h"

namespace ganglion::config {
namespace {

/// How often a text is looked through in vain before values that do not end near by are taken to end with their line:
/// thousands of lists that are not closed must not take forever.
constexpr std::size_t kMostWasted = 16;
constexpr std::size_t kNear = 1000;

bool is_bare(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
  }

  SourceMap run() {
    map_.sections.emplace_back();
    map_.sections.back().begin = at_;
    map_.sections.back().body_end = at_;
    comments_ = at_;
    while (at_ < text_.size()) read_line();
    map_.sections.back().end = text_.size();
    return std::move(map_);
  }

 private:
  char peek() const noexcept { return at_ < text_.size() ? text_[at_] : '\n'; }
  void skip_blanks() noexcept {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r')) ++at_;
  }

  /// To the start of the next line.
  void finish_line() noexcept {
    at_ = std::min(text_.find('\n', at_), text_.size());
    if (at_ < text_.size()) ++at_;
    ++line_;
  }

  void read_line() {
    const std::size_t begin = at_;
    skip_blanks();
    switch (peek()) {
      case '\n':
        finish_line();
        comments_ = at_;
        break;
      case '#':
        finish_line();  // may belong to the header below
        break;
      case '[':
        read_header(begin);
        comments_ = at_;
        break;
      default:
        read_member(begin);
        comments_ = at_;
        break;
    }
  }

  std::string read_key() {
    std::string key;
    while (true) {
      skip_blanks();
      if (peek() == '"' || peek() == '\'') {
        const std::size_t from = at_;
        at_ = string_end(text_, at_);
        key += unquoted(text_.substr(from, at_ - from));
      }
      while (is_bare(peek())) key += text_[at_++];
      skip_blanks();
      if (peek() != '.') return key;
      key += text_[at_++];
    }
  }

  void read_header(std::size_t begin) {
    SectionSource section;
    section.begin = comments_;
    section.line = line_;
    ++at_;
    section.list = peek() == '[';
    if (section.list) ++at_;
    section.name = read_key();
    finish_line();
    section.header = {begin, at_};
    section.body_end = at_;
    map_.sections.back().end = section.begin;
    map_.sections.push_back(std::move(section));
  }

  void read_member(std::size_t begin) {
    MemberSource member;
    member.line = line_;
    member.key = read_key();
    if (peek() == '=') {
      ++at_;
      skip_blanks();
      member.value.begin = at_;
      skip_value();
      member.value.end = at_;
    } else {
      member.key.clear();
      member.value = {at_, at_};
    }
    line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(begin),
                                         text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n'));
    member.last_line = line_;
    finish_line();
    member.lines = {begin, at_};
    SectionSource& section = map_.sections.back();
    section.body_end = at_;
    if (text_[member.value.begin < text_.size() ? member.value.begin : 0] == '{' && member.value.size() > 1) {
      add_inline(section, member);
    }
    section.members.push_back(std::move(member));
  }

  /// To the end of a value. What is not closed ends with its line, so that one slip does not hide all that follows.
  void skip_value() {
    const std::size_t from = at_;
    const std::string_view ahead = text_.substr(0, wasted_ < kMostWasted * text_.size() ? text_.size() : from + kNear);
    int depth = 0;
    while (at_ < ahead.size()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'') {
        at_ = string_end(ahead, at_);
        if (depth == 0) return;
        continue;
      }
      if (c == '#' && depth == 0) break;
      if (c == '#') {
        at_ = comment_end(ahead, at_);
        continue;
      }
      if (c == '\n' && depth == 0) break;
      if (c == '[' || c == '{') ++depth;
      ++at_;
      if ((c == ']' || c == '}') && --depth <= 0) return;
    }
    if (depth > 0) {
      wasted_ += at_ - from;
      at_ = std::min(text_.find('\n', from), text_.size());
    }
    while (at_ > from && (text_[at_ - 1] == ' ' || text_[at_ - 1] == '\t' || text_[at_ - 1] == '\r')) --at_;
  }

  /// The members of an inline table, each as a member of its own.
  void add_inline(SectionSource& section, const MemberSource& whole) {
    const std::size_t back = at_;
    at_ = whole.value.begin + 1;
    while (at_ + 1 < whole.value.end) {
      skip_blanks();
      MemberSource member = whole;
      member.inline_key = whole.key;
      const std::string key = read_key();
      if (key.empty() || peek() != '=') break;
      ++at_;
      skip_blanks();
      member.key = whole.key + "." + key;
      member.value.begin = at_;
      skip_inline_value(whole.value.end - 1);
      member.value.end = at_;
      section.members.push_back(std::move(member));
      skip_blanks();
      if (peek() == ',') ++at_;
    }
    at_ = back;
  }

  void skip_inline_value(std::size_t limit) {
    const char c = peek();
    if (c == '"' || c == '\'' || c == '[' || c == '{') {
      skip_value();
    } else {
      while (at_ < limit && text_[at_] != ',' && text_[at_] != ' ' && text_[at_] != '}') ++at_;
    }
    at_ = std::min(at_, limit);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t wasted_ = 0;    // looked through for the ends of values that have none
  std::size_t comments_ = 0;  // where the comments directly above this line begin
  int line_ = 1;
  SourceMap map_;
};

std::string id_of(const SectionSource& section, std::string_view text) {
  const MemberSource* id = section.member("id");
  return id != nullptr ? unquoted(id->value.of(text)) : std::string();
}

}  // namespace

const MemberSource* SectionSource::member(std::string_view key) const noexcept {
  for (const MemberSource& one : members) {
    if (one.key == key) return &one;
  }
  return nullptr;
}

SourceMap map_source(std::string_view text) { return Scanner(text).run(); }

std::string ItemSource::prefix(const SourceMap& map, std::size_t section) const {
  if (section == sections.front()) return "";
  return map.sections[section].name.substr(list.size() + 1) + ".";
}

std::vector<ItemSource> items_of(const SourceMap& map, std::string_view text, std::span<const std::string_view> lists) {
  std::vector<ItemSource> result;
  std::vector<std::size_t> last(lists.size());  // of each list, counted from 1
  for (std::size_t i = 0; i < map.sections.size(); ++i) {
    const SectionSource& section = map.sections[i];
    const std::size_t dot = section.name.find('.');
    const std::string_view root = std::string_view(section.name).substr(0, dot);
    const auto known = std::find(lists.begin(), lists.end(), root);
    if (known == lists.end()) continue;
    std::size_t& owner = last[static_cast<std::size_t>(known - lists.begin())];
    if (section.list && dot == std::string::npos) {
      result.push_back({section.name, id_of(section, text), {i}});
      owner = result.size();
    } else if (dot != std::string::npos && owner > 0) {
      result[owner - 1].sections.push_back(i);
    }
  }
  return result;
}

std::string unquoted(std::string_view toml) {
  if (toml.size() < 2 || (toml[0] != '"' && toml[0] != '\'')) return "";
  const std::string_view inner = toml.substr(1, toml.size() - 2);
  const bool plain = toml.back() == toml[0] && inner.find('\\') == std::string_view::npos &&
                     inner.find(toml[0]) == std::string_view::npos;
  if (plain) return std::string(inner);
  const auto parsed = parse("v = " + std::string(toml), "");
  if (!parsed || parsed->table()->size() != 1) return "";
  const std::string* text = parsed->table()->front().second.string();
  return text != nullptr ? *text : std::string();
}

std::string toml_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      result += fmt::format("\\u{:04x}", byte);
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::vector<Region> strings_in(std::string_view text, Region value) {
  std::vector<Region> result;
  for (std::size_t at = value.begin; at < value.end;) {
    if (text[at] == '"' || text[at] == '\'') {
      const std::size_t end = std::min(string_end(text, at), value.end);
      result.push_back({at, end});
      at = end;
    } else if (text[at] == '#') {
      at = comment_end(text, at);
    } else {
      ++at;
    }
  }
  return result;
}

}  // namespace ganglion::config
