#include "ganglion/studio/api/query.h"

#include <algorithm>

#include "ganglion/base/text.h"

namespace ganglion::studio {
namespace {

int hex_digit(char c) noexcept {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

std::optional<std::string> percent_decoded(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      result += text[i];
      continue;
    }
    const int high = i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
    const int low = i + 2 < text.size() ? hex_digit(text[i + 2]) : -1;
    if (high < 0 || low < 0 || (high == 0 && low == 0)) return std::nullopt;
    result += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return result;
}

std::optional<std::string> query_value(std::string_view target, std::string_view name) {
  const std::size_t question = target.find('?');
  if (question == std::string_view::npos) return std::nullopt;
  for (const std::string& part : split(target.substr(question + 1), '&')) {
    const std::size_t equals = std::min(part.find('='), part.size());
    if (std::string_view(part).substr(0, equals) != name) continue;
    return percent_decoded(std::string_view(part).substr(std::min(equals + 1, part.size())));
  }
  return std::nullopt;
}

}  // namespace ganglion::studio
