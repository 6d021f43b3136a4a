#include "ganglion/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

namespace ganglion {
namespace {

std::string lower(std::string_view word) {
  std::string result(word);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  const std::size_t width = b.size() + 1;
  std::vector<int> cost((a.size() + 1) * width);
  auto at = [&](std::size_t i, std::size_t j) -> int& { return cost[i * width + j]; };
  for (std::size_t i = 0; i <= a.size(); ++i) at(i, 0) = static_cast<int>(i);
  for (std::size_t j = 0; j <= b.size(); ++j) at(0, j) = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, at(i - 1, j - 1) + (a[i - 1] != b[j - 1] ? 1 : 0)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
    }
  }
  return at(a.size(), b.size());
}

std::optional<std::string> nearest(std::string_view word, std::span<const std::string> candidates) {
  if (word.size() > 100) return std::nullopt;
  const std::string wanted = lower(word);
  int best = std::numeric_limits<int>::max();
  const std::string* found = nullptr;
  for (const std::string& candidate : candidates) {
    const int distance = edit_distance(wanted, lower(candidate));
    const int allowed = std::max<int>(1, static_cast<int>(std::max(word.size(), candidate.size())) / 3);
    if (distance <= allowed && distance < best) {
      best = distance;
      found = &candidate;
    }
  }
  return found != nullptr ? std::optional<std::string>(*found) : std::nullopt;
}

Sentence suggestion(std::string_view word, std::span<const std::string> candidates) {
  if (const auto near = nearest(word, candidates)) {
    return say({"; did you mean \"{}\"?", "; ¿quiso decir \"{}\"?"}, *near);
  }
  if (candidates.empty()) return {};
  constexpr std::size_t kMost = 12;
  const auto shown = candidates.subspan(0, std::min(kMost, candidates.size()));
  return say({"; valid: {}{}", "; válidos: {}{}"}, join(shown), candidates.size() > kMost ? ", ..." : "");
}

std::string join(std::span<const std::string> words, std::string_view separator) {
  return fmt::format("{}", fmt::join(words, separator));
}

std::string shortest(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return fmt::format("{}", value);
}

std::optional<double> parse_number(std::string_view word) noexcept {
  if (word == "nan" || word == "NaN") return std::numeric_limits<double>::quiet_NaN();
  if (word == "inf" || word == "+inf" || word == "Infinity" || word == "+Infinity")
    return std::numeric_limits<double>::infinity();
  if (word == "-inf" || word == "-Infinity") return -std::numeric_limits<double>::infinity();
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  std::size_t start = 0;
  while (true) {
    const std::size_t end = text.find(separator, start);
    parts.emplace_back(text.substr(start, end == std::string_view::npos ? end : end - start));
    if (end == std::string_view::npos) return parts;
    start = end + 1;
  }
}

std::string printable(std::string_view text, std::size_t most) {
  const bool cut = text.size() > most;
  if (cut) {
    while (most > 0 && (text[most] & 0xC0) == 0x80) --most;  // not within a letter
    text = text.substr(0, most);
  }
  std::string result;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || code == 0x7f) {
      result += fmt::format("\\x{:02x}", code);
    } else {
      result += c;
    }
  }
  return cut ? result + "..." : result;
}

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

std::optional<std::size_t> first_not_utf8(std::string_view text) noexcept {
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t bytes = letter_bytes(text.substr(at));
    if (bytes == 0) return at;
    at += bytes;
  }
  return std::nullopt;
}

std::string_view trimmed(std::string_view text) noexcept {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
  return text;
}

}  // namespace ganglion
