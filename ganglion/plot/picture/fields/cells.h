#pragma once

#include <array>

#include "ganglion/plot/canvas/axes.h"
#include "ganglion/record/exhibit/shown.h"

namespace ganglion::plot {

/// The known part of a field as it is drawn: blocks of `step` x `step` cells, so that the largest field stays a picture.
class Cells {
 public:
  /// Around what is known `margin` cells more.
  Cells(const shown::Field& field, int margin);

  Vector2 lower() const noexcept { return at(low_[0] - margin_, low_[1] - margin_); }
  Vector2 upper() const noexcept { return at(high_[0] + margin_, high_[1] + margin_); }
  Vector2 block() const noexcept { return field_->cell * step_; }

  /// `use(lower corner, byte)` for every known block of a layer: of its cells the highest.
  template <class Use>
  void for_each(std::size_t layer, Use use) const {
    for (int row = low_[1]; row < high_[1]; row += step_) {
      for (int column = low_[0]; column < high_[0]; column += step_) {
        const std::uint8_t byte = highest(layer, column, row);
        if (byte != shown::kUnknownCell) use(at(column, row), byte);
      }
    }
  }

 private:
  Vector2 at(int column, int row) const noexcept {
    return field_->origin + Vector2{column * field_->cell.x, row * field_->cell.y};
  }
  std::uint8_t highest(std::size_t layer, int column, int row) const noexcept;

  const shown::Field* field_;
  int margin_;
  std::array<int, 2> low_{}, high_{};
  int step_ = 1;
};

}  // namespace ganglion::plot
