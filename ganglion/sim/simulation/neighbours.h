#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ganglion/sim/world/shape.h"

namespace ganglion::sim {

/// Where the robots are, and who is near whom without asking all of them: a counting sort into square cells, row by
/// row. What it finds does not depend on the cells.
class Neighbours {
 public:
  /// Takes the memory for so many robots.
  void make_room(std::size_t robots);
  void put(std::size_t robot, const Disc& disc) noexcept;
  std::span<const Disc> discs() const noexcept { return discs_; }
  /// Sorts them as they stand. Needed now and then only: the farther they moved since, the more cells are looked into.
  void sort() noexcept;
  /// The robots but one whose centre now lies within range_m of a place, as indices in rising order. Valid until the
  /// next call.
  std::span<const std::uint32_t> within(Vector2 place, double range_m, std::size_t left_out) noexcept;

 private:
  int column_of(double x) const noexcept { return clamped((x - lower_.x) * per_m_, columns_); }
  int row_of(double y) const noexcept { return clamped((y - lower_.y) * per_m_, rows_); }
  static int clamped(double index, int count) noexcept {
    return index >= count ? count - 1 : (index > 0 ? static_cast<int>(index) : 0);  // NaN gives 0
  }
  void lay_out() noexcept;

  std::vector<Disc> discs_;
  std::vector<Vector2> sorted_at_;  // where each was when it was sorted
  double moved_m_ = 0;              // the farthest that any has moved since
  Vector2 lower_;
  double per_m_ = 1;  // cells a metre
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::uint32_t> cell_;   // of each robot
  std::vector<std::uint32_t> start_;  // of cell n in order_ at n + 1
  std::vector<std::uint32_t> order_;  // robots, cell by cell
  std::vector<std::uint32_t> found_;
};

}  // namespace ganglion::sim
