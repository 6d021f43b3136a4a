#include "ganglion/plot/canvas/canvas.h"

namespace ganglion::plot {
namespace {

constexpr std::size_t kMaxTextBytes = 400;

/// Length of the valid UTF-8 sequence at the start of `text` that XML 1.0 may hold; 0 = none. Source: RFC 3629, table
/// 3-7 of the Unicode standard.
std::size_t sequence_length(std::string_view text) noexcept {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const auto tail = [&](std::size_t i) { return (byte(i) & 0xc0) == 0x80; };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  if (first >= 0xc2 && first <= 0xdf) return tail(1) && !(first == 0xc2 && byte(1) < 0xa0) ? 2 : 0;
  if (first >= 0xe0 && first <= 0xef) {
    const bool overlong = first == 0xe0 && byte(1) < 0xa0;
    const bool surrogate = first == 0xed && byte(1) >= 0xa0;
    const bool no_character = first == 0xef && byte(1) == 0xbf && byte(2) >= 0xbe;
    return tail(1) && tail(2) && !overlong && !surrogate && !no_character ? 3 : 0;
  }
  if (first >= 0xf0 && first <= 0xf4) {
    const bool outside = (first == 0xf0 && byte(1) < 0x90) || (first == 0xf4 && byte(1) >= 0x90);
    return tail(1) && tail(2) && tail(3) && !outside ? 4 : 0;
  }
  return 0;
}

}  // namespace

std::string clean_text(std::string_view words) {
  std::string result;
  for (std::size_t i = 0; i < words.size();) {
    const std::size_t length = sequence_length(words.substr(i));
    const std::string_view piece = length > 0                             ? words.substr(i, length)
                                   : words[i] == '\n' || words[i] == '\t' ? " "
                                                                          : "\uFFFD";
    if (result.size() + piece.size() > kMaxTextBytes) break;
    result += piece;
    i += length > 0 ? length : 1;
  }
  return result;
}

}  // namespace ganglion::plot
