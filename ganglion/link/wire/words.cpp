#include "ganglion/link/wire/words.h"

#include <array>

#include "ganglion/base/text.h"

namespace ganglion::link {
namespace {

constexpr std::size_t kMostBytes = 500;

/// Bytes of the letter that a text begins with; 0 = it begins with no UTF-8. Source: RFC 3629.
std::size_t letter_bytes(std::string_view text) noexcept {
  constexpr std::array<unsigned, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  const auto at = [&](std::size_t n) { return n < text.size() ? static_cast<unsigned char>(text[n]) : 0u; };
  if (at(0) < 0x80) return 1;
  const std::size_t bytes = at(0) < 0xE0 ? 2 : at(0) < 0xF0 ? 3 : 4;
  unsigned letter = at(0) & (0x7Fu >> bytes);
  for (std::size_t n = 1; n < bytes; ++n) {
    if ((at(n) & 0xC0) != 0x80) return 0;
    letter = letter << 6 | (at(n) & 0x3F);
  }
  const bool surrogate = letter >= 0xD800 && letter <= 0xDFFF;
  const bool good = at(0) >= 0xC0 && at(0) < 0xF8 && letter >= kLeast[bytes] && letter <= 0x10FFFF && !surrogate;
  return good ? bytes : 0;
}

/// As it may stand in a message.
std::string plain(std::string_view words) {
  const std::string text = printable(words, kMostBytes);
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t bytes = letter_bytes(std::string_view(text).substr(at));
    result += bytes == 0 ? "?" : text.substr(at, bytes);
    at += bytes == 0 ? 1 : bytes;
  }
  return result;
}

Sentence heard(const std::string& english, const std::string& spanish) {
  return {printable(english.empty() ? spanish : english, kMostBytes),
          printable(spanish.empty() ? english : spanish, kMostBytes)};
}

}  // namespace

void write_words(const Sentence& reason, wire::Bye& out) {
  out.set_reason(plain(reason.en));
  out.set_reason_es(reason.es == reason.en ? "" : plain(reason.es));
}

Sentence read_words(const wire::Bye& message) { return heard(message.reason(), message.reason_es()); }

Sentence read_words(const wire::Event& message) { return heard(message.text(), message.text_es()); }

}  // namespace ganglion::link
