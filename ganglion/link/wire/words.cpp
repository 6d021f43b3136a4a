#include "ganglion/link/wire/words.h"

#include "ganglion/base/text.h"

namespace ganglion::link {
namespace {

constexpr std::size_t kMostBytes = 500;

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
