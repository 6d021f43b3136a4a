#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ganglion {

struct SignalColumn {
  std::string name;
  std::string unit;
  friend bool operator==(const SignalColumn&, const SignalColumn&) = default;
};

/// What one robot's signals were, tick by tick.
struct SignalTable {
  std::string topic;  ///< "/robot0/signals".
  std::vector<SignalColumn> columns;
  std::vector<std::uint32_t> ticks;
  std::vector<double> times_s;
  std::vector<double> values;  ///< Row by row, columns.size() in each.

  std::size_t rows() const noexcept { return ticks.size(); }
  std::optional<std::size_t> column(std::string_view name) const noexcept;
  double at(std::size_t row, std::size_t column) const noexcept { return values[row * columns.size() + column]; }
  std::span<const double> row(std::size_t index) const noexcept {
    return std::span(values).subspan(index * columns.size(), columns.size());
  }
};

}  // namespace ganglion
