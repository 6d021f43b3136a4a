#include "ganglion/application/ledger.h"

#include <algorithm>
#include <cmath>

#include "ganglion/application/witness.h"
#include "ganglion/base/text.h"

namespace ganglion {
namespace {

std::string spelt(const LedgerColumn& column, double value, Language language) {
  const auto words = static_cast<double>(column.words.size());
  if (value >= 0 && value < words && value == std::floor(value)) {
    return column.words[static_cast<std::size_t>(value)].in(language);
  }
  return shortest(value);
}

std::string row_in(const LedgerForm& form, std::size_t row, std::span<const double> values, Language language) {
  const std::string& line = form.line.in(language);
  std::string text;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t open = line.find('{', at), close = line.find('}', open);
    if (open == std::string::npos || close == std::string::npos) return text + line.substr(at);
    text += line.substr(at, open - at);
    const std::string name = line.substr(open + 1, close - open - 1);
    const auto column = form.column(name);
    if (name == "#") {
      text += std::to_string(row + 1);
    } else if (column && *column < values.size()) {
      text += spelt(form.columns[*column], values[*column], language);
    } else {
      text += line.substr(open, close + 1 - open);
    }
    at = close + 1;
  }
  return text;
}

}  // namespace

std::optional<std::size_t> LedgerForm::column(std::string_view name) const noexcept {
  const auto found = std::ranges::find(columns, name, &LedgerColumn::name);
  if (found == columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns.begin());
}

Sentence row_text(const LedgerForm& form, std::size_t row, std::span<const double> values) {
  return {row_in(form, row, values, Language::English), row_in(form, row, values, Language::Spanish)};
}

std::optional<std::size_t> index_of(std::span<const TruthChannel> channels, std::string_view name) noexcept {
  const auto found = std::ranges::find(channels, name, &TruthChannel::name);
  if (found == channels.end()) return std::nullopt;
  return static_cast<std::size_t>(found - channels.begin());
}

}  // namespace ganglion
