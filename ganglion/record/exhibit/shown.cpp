#include "ganglion/record/exhibit/shown.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ganglion::shown {
namespace {

constexpr double kTop = 254;

std::size_t at(int columns, int row, int column) noexcept {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
}

}  // namespace

std::uint8_t Layer::byte_of(double value) const noexcept {
  const double part = (value - low) / (high - low);
  if (std::isnan(part)) return kUnknownCell;
  return static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0, 1.0) * kTop));
}

double Layer::value_of(std::uint8_t byte) const noexcept {
  return byte == kUnknownCell ? std::numeric_limits<double>::quiet_NaN() : low + (high - low) * (byte / kTop);
}

const Class* Layer::class_of(std::uint8_t byte) const noexcept {
  if (byte == kUnknownCell || classes.empty()) return nullptr;
  const double value = value_of(byte);
  const auto farther = [value](const Class& one, const Class& other) {
    return std::abs(one.value - value) < std::abs(other.value - value);
  };
  return &*std::min_element(classes.begin(), classes.end(), farther);
}

bool Field::same_make(const Field& other) const noexcept {
  return columns == other.columns && rows == other.rows && origin == other.origin && cell == other.cell &&
         frame == other.frame && across == other.across && up == other.up && layers == other.layers &&
         cells.size() == other.cells.size();
}

bool fits(const Patch& patch, const Field& field) {
  const bool inside = patch.column >= 0 && patch.row >= 0 && patch.columns >= 1 && patch.rows >= 1 &&
                      patch.columns <= field.columns - patch.column && patch.rows <= field.rows - patch.row;
  const std::size_t size = inside ? at(patch.columns, patch.rows, 0) : 0;
  return inside && patch.cells.size() == field.cells.size() &&
         std::ranges::all_of(patch.cells, [size](const auto& layer) { return layer.size() == size; });
}

bool apply(const Patch& patch, Field& field) {
  if (!fits(patch, field)) return false;
  for (std::size_t layer = 0; layer < patch.cells.size(); ++layer) {
    for (int row = 0; row < patch.rows; ++row) {
      const auto from = patch.cells[layer].begin() + static_cast<std::ptrdiff_t>(at(patch.columns, row, 0));
      std::copy(
          from, from + patch.columns,
          field.cells[layer].begin() + static_cast<std::ptrdiff_t>(at(field.columns, patch.row + row, patch.column)));
    }
  }
  return true;
}

std::optional<Patch> difference(const Field& before, const Field& now) {
  int left = now.columns, right = -1, low = now.rows, high = -1;
  for (std::size_t layer = 0; layer < now.cells.size(); ++layer) {
    for (int row = 0; row < now.rows; ++row) {
      const auto old_row = before.cells[layer].begin() + static_cast<std::ptrdiff_t>(at(now.columns, row, 0));
      const auto new_row = now.cells[layer].begin() + static_cast<std::ptrdiff_t>(at(now.columns, row, 0));
      if (std::equal(new_row, new_row + now.columns, old_row)) continue;
      low = std::min(low, row), high = std::max(high, row);
      for (int column = 0; column < now.columns; ++column) {
        if (old_row[column] != new_row[column]) left = std::min(left, column), right = std::max(right, column);
      }
    }
  }
  if (right < 0) return std::nullopt;
  Patch patch{left, low, right - left + 1, high - low + 1, {}};
  for (const auto& layer : now.cells) {
    std::vector<std::uint8_t>& cells = patch.cells.emplace_back();
    for (int row = low; row <= high; ++row) {
      const auto from = layer.begin() + static_cast<std::ptrdiff_t>(at(now.columns, row, left));
      cells.insert(cells.end(), from, from + patch.columns);
    }
  }
  return patch;
}

}  // namespace ganglion::shown
