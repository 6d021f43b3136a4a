#include "ganglion/plot/picture/fields/cells.h"

#include <algorithm>

namespace ganglion::plot {
namespace {

constexpr int kMostDrawn = 400;  // cells each way

}  // namespace

Cells::Cells(const shown::Field& field, int margin) : field_(&field), margin_(margin) {
  low_ = {field.columns, field.rows};
  high_ = {0, 0};
  for (const auto& layer : field.cells) {
    for (int row = 0; row < field.rows; ++row) {
      for (int column = 0; column < field.columns; ++column) {
        const auto i = static_cast<std::size_t>(row) * static_cast<std::size_t>(field.columns);
        if (layer[i + static_cast<std::size_t>(column)] == shown::kUnknownCell) continue;
        low_ = {std::min(low_[0], column), std::min(low_[1], row)};
        high_ = {std::max(high_[0], column + 1), std::max(high_[1], row + 1)};
      }
    }
  }
  if (low_[0] >= high_[0]) low_ = {0, 0}, high_ = {field.columns, field.rows};
  step_ = std::max(1, (std::max(high_[0] - low_[0], high_[1] - low_[1]) + kMostDrawn - 1) / kMostDrawn);
}

std::uint8_t Cells::highest(std::size_t layer, int column, int row) const noexcept {
  int highest = -1;
  for (int r = row; r < std::min(row + step_, high_[1]); ++r) {
    for (int c = column; c < std::min(column + step_, high_[0]); ++c) {
      const auto i = static_cast<std::size_t>(r) * static_cast<std::size_t>(field_->columns);
      const std::uint8_t byte = field_->cells[layer][i + static_cast<std::size_t>(c)];
      if (byte != shown::kUnknownCell) highest = std::max<int>(highest, byte);
    }
  }
  return highest < 0 ? shown::kUnknownCell : static_cast<std::uint8_t>(highest);
}

}  // namespace ganglion::plot
