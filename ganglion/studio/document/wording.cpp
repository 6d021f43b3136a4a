#include "ganglion/studio/document/wording.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "ganglion/studio/document/spanish.h"

namespace ganglion::studio {
namespace {

constexpr int kDeepest = 5;
constexpr std::size_t kLongest = 20'000;

/// What stands at each {} of a pattern; none where the message is no such sentence. Each takes as little as it can, so
/// that time is linear.
std::optional<std::vector<std::string_view>> match(std::string_view pattern, std::string_view message) {
  std::vector<std::string_view> found;
  std::size_t hole = pattern.find("{}");
  if (!message.starts_with(pattern.substr(0, hole))) return std::nullopt;
  if (hole == std::string_view::npos) return pattern == message ? std::optional(found) : std::nullopt;
  message.remove_prefix(hole);
  while (hole != std::string_view::npos) {
    pattern.remove_prefix(hole + 2);
    hole = pattern.find("{}");
    const std::string_view literal = pattern.substr(0, hole);
    const bool last = hole == std::string_view::npos;
    std::size_t end = literal.empty() && last ? message.size() : message.find(literal);
    if (last && !literal.empty()) end = message.ends_with(literal) ? message.size() - literal.size() : message.npos;
    if (end == std::string_view::npos) return std::nullopt;
    found.push_back(message.substr(0, end));
    message.remove_prefix(end + literal.size());
  }
  return message.empty() ? std::optional(found) : std::nullopt;
}

std::optional<std::string> in_spanish(std::string_view message, int depth);

std::string filled(std::string_view pattern, const std::vector<std::string_view>& pieces, int depth) {
  std::string result;
  while (!pattern.empty()) {
    const bool hole =
        pattern.size() > 2 && pattern[0] == '{' && pattern[2] == '}' && pattern[1] >= '0' && pattern[1] <= '9';
    if (!hole) {
      result += pattern.front();
      pattern.remove_prefix(1);
      continue;
    }
    const auto index = static_cast<std::size_t>(pattern[1] - '0');
    const std::string_view piece = index < pieces.size() ? pieces[index] : std::string_view();
    const bool quoted = result.ends_with('"') && pattern.substr(3).starts_with('"');  // a name, which stays what it is
    result += quoted ? std::string(piece) : in_spanish(piece, depth + 1).value_or(std::string(piece));
    pattern.remove_prefix(3);
  }
  return result;
}

std::optional<std::string> in_spanish(std::string_view message, int depth) {
  if (message.empty() || depth > kDeepest) return std::nullopt;
  for (const Phrase& phrase : spanish_phrases()) {
    if (const auto pieces = match(phrase.en, message)) return filled(phrase.es, *pieces, depth);
  }
  return std::nullopt;
}

/// "avoid: " of a message that opens with a component's id.
std::size_t context_of(std::string_view message) {
  const std::size_t colon = message.find(": ");
  if (colon == std::string_view::npos || colon == 0 || colon > 200) return 0;
  const bool word = std::all_of(message.begin(), message.begin() + static_cast<std::ptrdiff_t>(colon), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
  });
  return word ? colon + 2 : 0;
}

}  // namespace

std::string worded(std::string_view message, Language language) {
  if (language == Language::English || message.size() > kLongest) return std::string(message);
  const std::size_t context = context_of(message);
  if (const auto spanish = in_spanish(message.substr(context), 0)) {
    return std::string(message.substr(0, context)) + *spanish;
  }
  return std::string(message);
}

}  // namespace ganglion::studio
