#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/record/signal_table.h"

namespace ganglion {

/// A table of numbers with a line of names on top.
struct Csv {
  std::vector<std::string> columns;
  std::vector<double> values;  ///< Row by row.

  std::size_t rows() const noexcept { return columns.empty() ? 0 : values.size() / columns.size(); }
  std::optional<std::size_t> column(std::string_view name) const noexcept;
  double at(std::size_t row, std::size_t column) const noexcept { return values[row * columns.size() + column]; }
};

/// Limits of read_csv().
inline constexpr std::size_t kMaxCsvColumns = 4096;
inline constexpr std::size_t kMaxCsvValues = std::size_t{1} << 26;

/// The table with the columns `tick` and `time_s` in front. Comma, "\n", the shortest decimals that read back; missing
/// readings are spelt nan, inf, -inf; names with commas or quotes stand in quotes (RFC 4180).
std::string to_csv(const SignalTable& table);
/// Fails with Unwritable.
Result<void> write_csv(const SignalTable& table, const std::filesystem::path& path);

/// Reads numbers under a line of names; "\r\n", a byte order mark, blanks around cells and empty last lines are
/// allowed. Fails, with line and column: Syntax (a cell that is no number, a row of another length, no names),
/// BadParameter (a name twice), TooLarge (limits above, and 256 MiB), NotFound, Unreadable.
Result<Csv> read_csv(const std::filesystem::path& path);
/// The same for text in memory; `name` is the file's name in messages.
Result<Csv> parse_csv(std::string_view text, const std::string& name);

/// A word as a CSV cell, in quotes where it needs them.
std::string csv_cell(std::string_view word);

}  // namespace ganglion
