#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/text.h"

namespace ganglion::config {

/// Spoils a good file the way people and accidents do, for tests: lines lost, doubled or swapped, letters changed,
/// files cut, numbers made absurd, quotes and brackets dropped or added. The same seed gives the same file.
class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : state_(seed) {}

  std::string mutated(std::string text) {
    for (std::size_t edits = 1 + below(3); edits > 0; --edits) {
      switch (below(6)) {
        case 0:
          text = edit_lines(text);
          break;
        case 1:
          replace_number(text);
          break;
        case 2:
          text.resize(below(text.size() + 1));
          break;
        case 3:
          text.erase(below(text.size() + 1), 1 + below(6));
          break;
        case 4:
          if (!text.empty()) text[below(text.size())] = static_cast<char>(below(256));
          break;
        default:
          text.insert(below(text.size() + 1), kPieces[below(kPieces.size())]);
      }
    }
    return text;
  }

  std::string_view piece() { return kPieces[below(kPieces.size())]; }
  std::string_view number() { return kNumbers[below(kNumbers.size())]; }

  /// A whole number in [0, limit), evenly enough for tests.
  std::size_t below(std::size_t limit) {
    state_ ^= state_ << 13;  // xorshift64, Marsaglia 2003
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return static_cast<std::size_t>(state_ % limit);
  }

 private:
  static constexpr std::array<std::string_view, 24> kPieces = {
      "\n",     "#",  "# note\n", "\"", "'", "[", "]",    "{",    "}", ",",         "=",      ".",
      "\"\"\"", "\\", "[layout]", "\t", "@", "ñ", "\r\n", "\xff", "😀", "@previous", "\u202e", "[[acting]]\n"};
  static constexpr std::array<std::string_view, 12> kNumbers = {
      "-1",   "0",      "nan",       "inf", "-inf", "1e308", "-1e308", "9223372036854775807", "99999999999999999999",
      "0x7f", "1e-320", "2147483648"};

  std::string edit_lines(const std::string& text) {
    std::vector<std::string> lines = split(text, '\n');
    const std::size_t at = below(lines.size());
    const std::string line = lines[at];
    const auto begin = lines.begin();
    switch (below(3)) {
      case 0:
        lines.erase(begin + static_cast<std::ptrdiff_t>(at));
        break;
      case 1:
        lines.insert(begin + static_cast<std::ptrdiff_t>(below(lines.size() + 1)), line);
        break;
      default:
        std::swap(lines[at], lines[below(lines.size())]);
    }
    return join(lines, "\n");
  }

  void replace_number(std::string& text) {
    constexpr std::string_view kDigits = "0123456789";
    const std::size_t first = text.find_first_of(kDigits, below(text.size() + 1));
    if (first == std::string::npos) return;
    const std::size_t end = std::min(text.find_first_not_of("0123456789.", first), text.size());
    text.replace(first, end - first, number());
  }

  std::uint64_t state_;
};

}  // namespace ganglion::config
