#include "ganglion/record/csv.h"

#include <algorithm>

#include "ganglion/base/file.h"
#include "ganglion/base/text.h"

namespace ganglion {
namespace {

struct Cell {
  std::string text;
  int column = 1;  ///< Of its first letter, from 1.
};

/// Cuts one line into cells. None when a quote is not closed.
std::optional<std::vector<Cell>> cells_of(std::string_view line) {
  std::vector<Cell> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      cells.back().text += line[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.push_back({"", static_cast<int>(i) + 2});
    } else {
      cells.back().text += c;
    }
  }
  if (quoted) return std::nullopt;
  for (Cell& cell : cells) cell.text = trimmed(cell.text);
  return cells;
}

class CsvParser {
 public:
  CsvParser(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Result<Csv> parse() {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
    auto outcome = header(next_line());
    while (outcome && !trimmed(text_).empty()) outcome = row(next_line());
    if (!outcome) return tl::unexpected(outcome.error());
    return std::move(csv_);
  }

 private:
  Place place(int column) const { return {name_, line_, column}; }

  std::string_view next_line() noexcept {
    ++line_;
    const std::size_t end = text_.find('\n');
    const std::string_view line = text_.substr(0, end);
    text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
    return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
  }

  Result<void> header(std::string_view line) {
    const auto cells = cells_of(line);
    if (!cells)
      return fail_at(place(1), ErrorCode::Syntax,
                     {"a quote is not closed on its line", "unas comillas no se cierran en su línea"});
    for (const char other : {';', '\t'}) {
      const std::size_t at = line.find(other);
      if (cells->size() > 1 || at == std::string_view::npos) continue;
      return fail_at(place(static_cast<int>(at) + 1), ErrorCode::Syntax,
                     {"columns are separated by {} here; write commas between them, and points in numbers",
                      "aquí las columnas se separan con {}; escriba comas entre ellas, y puntos en los números"},
                     other == ';' ? Text{"semicolons", "puntos y comas"} : Text{"tabs", "tabuladores"});
    }
    if (cells->size() > kMaxCsvColumns) {
      return fail_at(place(1), ErrorCode::TooLarge, {"{} columns; the limit is {}", "{} columnas; el límite es {}"},
                     cells->size(), kMaxCsvColumns);
    }
    for (const Cell& cell : *cells) {
      if (cell.text.empty())
        return fail_at(place(cell.column), ErrorCode::Syntax,
                       {"the first line must name every column", "la primera línea debe nombrar todas las columnas"});
      if (csv_.column(cell.text)) {
        return fail_at(place(cell.column), ErrorCode::BadParameter,
                       {"column \"{}\" is there twice", "la columna \"{}\" aparece dos veces"}, cell.text);
      }
      csv_.columns.push_back(cell.text);
    }
    return {};
  }

  Result<void> row(std::string_view line) {
    const auto cells = cells_of(line);
    if (!cells)
      return fail_at(place(1), ErrorCode::Syntax,
                     {"a quote is not closed on its line", "unas comillas no se cierran en su línea"});
    if (cells->size() != csv_.columns.size()) {
      return fail_at(place(1), ErrorCode::Syntax,
                     {"{} cells, where {} columns are named on line 1", "{} celdas, y la línea 1 nombra {} columnas"},
                     cells->size(), csv_.columns.size());
    }
    if (csv_.values.size() + cells->size() > kMaxCsvValues) {
      return fail_at(place(1), ErrorCode::TooLarge, {"over {} numbers", "más de {} números"}, kMaxCsvValues);
    }
    for (std::size_t i = 0; i < cells->size(); ++i) {
      const Cell& cell = (*cells)[i];
      const auto value = parse_number(cell.text);
      if (!value) {
        return fail_at(place(cell.column), ErrorCode::Syntax,
                       {"{}: \"{}\" is no number; valid: decimals, nan, inf, -inf",
                        "{}: \"{}\" no es un número; válidos: decimales, nan, inf, -inf"},
                       csv_.columns[i], cell.text);
      }
      csv_.values.push_back(*value);
    }
    return {};
  }

  std::string_view text_;
  const std::string& name_;
  int line_ = 0;
  Csv csv_;
};

}  // namespace

std::optional<std::size_t> Csv::column(std::string_view name) const noexcept {
  const auto found = std::find(columns.begin(), columns.end(), name);
  return found != columns.end() ? std::optional(static_cast<std::size_t>(found - columns.begin())) : std::nullopt;
}

std::string csv_cell(std::string_view word) {
  if (word.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(word);
  std::string cell = "\"";
  for (const char c : word) {
    if (c == '"') cell += '"';
    cell += c == '\n' || c == '\r' ? ' ' : c;  // our reader, like many, keeps to one line a row
  }
  return cell + '"';
}

std::string to_csv(const SignalTable& table) {
  std::string text = "tick,time_s";
  for (const SignalColumn& column : table.columns) text += "," + csv_cell(column.name);
  text += '\n';
  for (std::size_t row = 0; row < table.rows(); ++row) {
    text += std::to_string(table.ticks[row]);
    text += ',' + shortest(table.times_s[row]);
    for (const double value : table.row(row)) text += ',' + shortest(value);
    text += '\n';
  }
  return text;
}

Result<void> write_csv(const SignalTable& table, const std::filesystem::path& path) {
  return write_file(path, to_csv(table));
}

Result<Csv> parse_csv(std::string_view text, const std::string& name) { return CsvParser(text, name).parse(); }

Result<Csv> read_csv(const std::filesystem::path& path) {
  const auto text = read_file(path);
  if (!text) return tl::unexpected(text.error());
  return parse_csv(*text, path.string());
}

}  // namespace ganglion
