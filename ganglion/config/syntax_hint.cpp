#include "ganglion/config/syntax_hint.h"

#include <fmt/format.h>

#include <array>

namespace ganglion::config {
namespace {

struct Hint {
  std::string_view parsing;  ///< What was being read, as the parser names it; "" = whatever.
  std::string_view complaint;
  std::string_view words;
};

/// The first that fits counts.
constexpr std::array kHints = {
    Hint{"", "utf-8", "the file must be saved as UTF-8"},
    Hint{"string", "control characters",
         "a text must be closed by its quote on the same line, and holds no control characters"},
    Hint{"string", "end-of-file", "a text is not closed by its quotes"},
    Hint{"string", "escape sequence", "a \\ starts an escape; write \\\\, or put the text in 'single quotes'"},
    Hint{"", "could not determine value type", "this is no value; texts stand in quotes, \"like this\""},
    Hint{"key-value pair", "expected value", "after = a value is missing"},
    Hint{"key-value pair", "expected '='", "after a key come = and a value"},
    Hint{"key-value pair", "saw ','", "one value a line; decimals have a point, as in 0.5"},
    Hint{"key-value pair", "expected a comment", "after its value a line must end"},
    Hint{"table header", "expected", "a header is written [name] or [[name]], alone on its line"},
    Hint{"number", "leading zeroes", "a number has no leading zeros"},
    Hint{"number", "not representable", "this number is too large"},
    Hint{"number", "expected", "this is no number; write 12, 0.5 or 1e-3, without a unit"},
    Hint{"boolean", "expected", "write true or false, in small letters"},
    Hint{"array", "expected", "the items of a list are separated by commas, and a ] closes it"},
    Hint{"inline table", "expected", "{ x = 1, y = 2 } is closed on its line, its members separated by commas"},
    Hint{"root table", "expected", "a line starts with a key, a [header] or a # comment"},
};

bool is_number(std::string_view parsing) noexcept {
  return parsing.ends_with("integer") || parsing.ends_with("floating-point");
}

}  // namespace

std::string syntax_hint(std::string_view description) {
  constexpr std::string_view kOpening = "Error while parsing ";
  std::string_view parsing, complaint = description;
  if (const auto colon = description.find(": "); description.starts_with(kOpening) && colon != std::string_view::npos) {
    parsing = description.substr(kOpening.size(), colon - kOpening.size());
    complaint = description.substr(colon + 2);
  }
  if (complaint.starts_with("cannot redefine existing")) {
    const auto open = complaint.find('\''), close = complaint.rfind('\'');
    if (open == close) return "this name was used above for something else";
    return fmt::format("\"{}\" was given above; each key and each [table] stands once",
                       complaint.substr(open + 1, close - open - 1));
  }
  if (is_number(parsing)) parsing = "number";
  for (const Hint& hint : kHints) {
    const bool fits = hint.parsing.empty() || parsing.ends_with(hint.parsing);
    if (fits && complaint.find(hint.complaint) != std::string_view::npos) return std::string(hint.words);
  }
  return std::string(complaint);
}

}  // namespace ganglion::config
