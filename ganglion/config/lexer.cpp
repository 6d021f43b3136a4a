#include "ganglion/config/lexer.h"

#include <algorithm>
#include <vector>

namespace ganglion::config {
namespace {

/// Past a string closed by one quote; an unclosed one ends with its line.
std::size_t line_string_end(std::string_view text, std::size_t at, char quote) noexcept {
  for (; at < text.size() && text[at] != '\n'; ++at) {
    if (text[at] == quote) return at + 1;
    if (text[at] == '\\' && quote == '"') ++at;
  }
  return std::min(at, text.size());
}

/// Past a string closed by three quotes; up to two more before them belong to it.
std::size_t block_string_end(std::string_view text, std::size_t at, char quote) noexcept {
  const std::string closing(3, quote);
  for (; at < text.size(); ++at) {
    if (text[at] == '\\' && quote == '"') {
      ++at;
    } else if (text.substr(at).starts_with(closing)) {
      at += 3;
      for (int more = 0; more < 2 && at < text.size() && text[at] == quote; ++more) ++at;
      return at;
    }
  }
  return text.size();
}

/// How deep the place being read lies, counting one for each bracket and for each dot of a key.
class Depth {
 public:
  void take(char c) {
    switch (c) {
      case '[':
      case '{':
        dots_.push_back(0);
        break;
      case ']':
      case '}':
        if (dots_.size() > 1) dots_.pop_back();
        break;
      case '.':
        ++dots_.back();
        break;
      case ',':
        dots_.back() = 0;
        break;
      case '\n':
        if (dots_.size() == 1) dots_.back() = 0;
        break;
      default:
        return;
    }
    total_ = static_cast<int>(dots_.size());
    for (const int dots : dots_) total_ += dots;
  }
  int value() const noexcept { return total_; }

 private:
  std::vector<int> dots_{0};  // of the key or number being read, for each open bracket
  int total_ = 1;
};

}  // namespace

std::size_t string_end(std::string_view text, std::size_t at) noexcept {
  const char quote = text[at];
  const bool block = at + 2 < text.size() && text[at + 1] == quote && text[at + 2] == quote;
  return block ? block_string_end(text, at + 3, quote) : line_string_end(text, at + 1, quote);
}

std::size_t comment_end(std::string_view text, std::size_t at) noexcept {
  return std::min(text.find('\n', at), text.size());
}

Result<void> check_nesting(std::string_view text, const std::string& file_name, int limit) {
  Depth depth;
  std::size_t at = 0;
  while (at < text.size()) {
    if (text[at] == '"' || text[at] == '\'') {
      at = string_end(text, at);
    } else if (text[at] == '#') {
      at = comment_end(text, at);
    } else {
      depth.take(text[at++]);
    }
    if (depth.value() <= limit) continue;
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    return fail_at({file_name, static_cast<int>(line), 1}, ErrorCode::TooLarge,
                   {"tables, lists and dotted names nested deeper than {}",
                    "tablas, listas y nombres con puntos anidados a más de {} niveles"},
                   limit);
  }
  return {};
}

}  // namespace ganglion::config
