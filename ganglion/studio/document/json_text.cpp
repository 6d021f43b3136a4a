#include "ganglion/studio/document/json_text.h"

#include <cmath>

#include <fmt/format.h>

namespace ganglion::studio {
namespace {

/// Bytes of the well-formed UTF-8 sequence at the start of a text; 0 = it is none.
std::size_t sequence(std::string_view text) noexcept {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const auto follows = [&](std::size_t i) { return i < text.size() && (byte(i) & 0xC0) == 0x80; };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead < 0xE0) return follows(1) ? 2 : 0;
  if (lead >= 0xE0 && lead < 0xF0) {
    const bool good =
        follows(1) && follows(2) && !(lead == 0xE0 && byte(1) < 0xA0) && !(lead == 0xED && byte(1) > 0x9F);
    return good ? 3 : 0;
  }
  if (lead < 0xF0 || lead > 0xF4) return 0;
  const bool good =
      follows(1) && follows(2) && follows(3) && !(lead == 0xF0 && byte(1) < 0x90) && !(lead == 0xF4 && byte(1) > 0x8F);
  return good ? 4 : 0;
}

}  // namespace

void JsonText::separate() {
  if (!first_) text_ += ',';
  first_ = false;
}

JsonText& JsonText::open(char bracket) {
  separate();
  text_ += bracket;
  first_ = true;
  return *this;
}

JsonText& JsonText::close(char bracket) {
  text_ += bracket;
  first_ = false;
  return *this;
}

JsonText& JsonText::key(std::string_view name) {
  separate();
  write_string(name);
  text_ += ':';
  first_ = true;
  return *this;
}

JsonText& JsonText::value(std::string_view text) {
  separate();
  write_string(text);
  return *this;
}

JsonText& JsonText::value(bool flag) { return raw(flag ? "true" : "false"); }
JsonText& JsonText::value(int number) { return raw(fmt::to_string(number)); }
JsonText& JsonText::value(double number) { return std::isfinite(number) ? raw(fmt::to_string(number)) : null(); }

JsonText& JsonText::raw(std::string_view json) {
  separate();
  text_ += json;
  return *this;
}

/// What is not UTF-8 becomes U+FFFD.
void JsonText::write_string(std::string_view text) {
  text_ += '"';
  while (!text.empty()) {
    const char c = text.front();
    const std::size_t size = sequence(text);
    if (c == '"' || c == '\\') {
      text_ += '\\';
      text_ += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      fmt::format_to(std::back_inserter(text_), "\\u{:04x}", static_cast<unsigned>(c));
    } else {
      text_ += size > 0 ? text.substr(0, size) : std::string_view("\xEF\xBF\xBD");
    }
    text.remove_prefix(size > 0 ? size : 1);
  }
  text_ += '"';
}

}  // namespace ganglion::studio
