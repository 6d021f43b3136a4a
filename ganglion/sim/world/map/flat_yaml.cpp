#include "ganglion/sim/world/map/flat_yaml.h"

#include <algorithm>

#include "ganglion/base/text.h"

namespace ganglion::sim {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{64} << 10;
constexpr std::size_t kMaxEntries = 100;

/// Everything before a comment: # at the start or behind white space, outside quotes.
std::string_view without_comment(std::string_view line) noexcept {
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if ((c == '"' || c == '\'') && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '[' || line[i - 1] == ',')) {
      quote = c;
    } else if (c == '#' && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t')) {
      return line.substr(0, i);
    }
  }
  return line;
}

Result<std::string> unquoted(std::string_view word, const Place& place) {
  const std::string_view inner = trimmed(word);
  if (inner.empty()) return fail_at(place, ErrorCode::Syntax, {"a value is missing", "falta un valor"});
  const char first = inner.front();
  if (first == '"' || first == '\'') {
    if (inner.size() < 2 || inner.back() != first || inner.substr(1, inner.size() - 2).find(first) != inner.npos) {
      return fail_at(
          place, ErrorCode::Syntax,
          {"the quote {} is not closed at the end of the value", "la comilla {} no está cerrada al final del valor"},
          first);
    }
    return std::string(inner.substr(1, inner.size() - 2));
  }
  if (std::string_view("{}[]&*!|>%@`").find(first) != std::string_view::npos) {
    return fail_at(place, ErrorCode::Syntax,
                   {"a map file has plain values, texts in quotes and lists [a, b, c] only",
                    "un archivo de mapa solo tiene valores simples, textos entre comillas y listas [a, b, c]"});
  }
  return std::string(inner);
}

/// Fills in the value of an entry from the text behind its colon.
Result<void> read_value(std::string_view text, YamlEntry& entry) {
  entry.is_list = text.starts_with('[');
  if (!entry.is_list) {
    auto item = unquoted(text, entry.place);
    if (!item) return tl::unexpected<Error>(item.error());
    entry.items.push_back(std::move(*item));
    return {};
  }
  if (!text.ends_with(']'))
    return fail_at(entry.place, ErrorCode::Syntax,
                   {"the list has no ] at the end of the line", "la lista no tiene ] al final de la línea"});
  for (const std::string& part : split(text.substr(1, text.size() - 2), ',')) {
    auto item = unquoted(part, entry.place);
    if (!item) return tl::unexpected<Error>(item.error());
    entry.items.push_back(std::move(*item));
  }
  return {};
}

class Parser {
 public:
  explicit Parser(const std::string& file_name) : file_(file_name) {}

  Result<void> line(std::string_view whole, int number) {
    const std::string_view content = without_comment(whole);
    const std::string_view text = trimmed(content);
    if (text.empty() || text == "---" || text == "...") return {};
    const auto indent = static_cast<int>(text.data() - whole.data());
    const Place place{file_, number, indent + 1};
    if (text == "-" || text.starts_with("- ")) return item(text.substr(1), place);
    if (indent > 0)
      return fail_at(place, ErrorCode::Syntax,
                     {"nothing is nested in a map file: start at the margin",
                      "en un archivo de mapa no hay nada anidado: empiece en el margen"});
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos || colon == 0 ||
        (colon + 1 < text.size() && text[colon + 1] != ' ' && text[colon + 1] != '\t')) {
      return fail_at(place, ErrorCode::Syntax, {"write key: value", "escriba clave: valor"});
    }
    return entry(std::string(trimmed(text.substr(0, colon))), trimmed(text.substr(colon + 1)), place, whole);
  }

  Result<std::vector<YamlEntry>> finish() {
    for (const YamlEntry& entry : entries_) {
      if (entry.items.empty())
        return fail_at(entry.place, ErrorCode::Syntax, {"{} has no value", "{} no tiene valor"}, entry.key);
    }
    return std::move(entries_);
  }

 private:
  Result<void> item(std::string_view text, const Place& place) {
    if (entries_.empty() || (!entries_.back().items.empty() && !dashed_)) {
      return fail_at(place, ErrorCode::Syntax,
                     {"a list item without a key above it", "un elemento de lista sin una clave encima"});
    }
    auto value = unquoted(text, place);
    if (!value) return tl::unexpected<Error>(value.error());
    dashed_ = entries_.back().is_list = true;
    entries_.back().items.push_back(std::move(*value));
    return {};
  }

  Result<void> entry(std::string key, std::string_view value, Place place, std::string_view whole) {
    if (entries_.size() >= kMaxEntries) {
      return fail_at(
          place, ErrorCode::TooLarge,
          {"has more than {} keys; a map file needs six", "tiene más de {} claves; un archivo de mapa necesita seis"},
          kMaxEntries);
    }
    const auto same = [&](const YamlEntry& entry) { return entry.key == key; };
    if (std::any_of(entries_.begin(), entries_.end(), same)) {
      return fail_at(place, ErrorCode::Syntax, {"{} is given twice", "{} se da dos veces"}, key);
    }
    if (!value.empty()) place.column = static_cast<int>(value.data() - whole.data()) + 1;
    dashed_ = false;
    entries_.push_back({std::move(key), {}, false, place});
    return value.empty() ? Result<void>{} : read_value(value, entries_.back());
  }

  std::string file_;
  std::vector<YamlEntry> entries_;
  bool dashed_ = false;  ///< The last entry is being written as `- item` lines.
};

}  // namespace

Result<std::vector<YamlEntry>> parse_flat_yaml(std::string_view text, const std::string& file_name) {
  if (text.size() > kMaxBytes) {
    return fail_at({file_name}, ErrorCode::TooLarge,
                   {"has {} bytes; a map file may have {}", "tiene {} bytes; un archivo de mapa puede tener {}"},
                   text.size(), kMaxBytes);
  }
  Parser parser(file_name);
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (auto read = parser.line(text.substr(0, end), ++number); !read) return tl::unexpected<Error>(read.error());
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parser.finish();
}

}  // namespace ganglion::sim
