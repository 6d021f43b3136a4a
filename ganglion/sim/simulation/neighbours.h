#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ganglion/sim/world/shape/shape.h"

namespace ganglion::sim {

/// Where the robots are, and who is near whom without asking all of them: a counting sort into square cells, row by
/// row, and for each robot lists of who is near or may come near while nobody goes farther than a little way (Verlet's
/// lists): a short one of those it may touch, a long one of those it may see. What it finds depends on neither.
class Neighbours {
 public:
  /// Takes the memory for so many robots, who mostly ask for what is within touch_m or within sight_m, the larger.
  void make_room(std::size_t robots, double touch_m, double sight_m);
  void put(std::size_t robot, const Disc& disc) noexcept;
  std::span<const Disc> discs() const noexcept { return discs_; }
  /// Sorts them as they stand. Needed now and then only: the farther they moved since, the more cells are looked into.
  void sort() noexcept;
  /// Sorts them if another step like the last one would make the lists useless.
  void sort_if_needed() noexcept;
  /// The robots but `robot` whose centre now lies within range_m of a place where that one stands or has just come to,
  /// as indices in rising order. Valid until the next call.
  std::span<const std::uint32_t> within(Vector2 place, double range_m, std::size_t robot) noexcept;

 private:
  int column_of(double x) const noexcept { return clamped((x - lower_.x) * per_m_, columns_); }
  int row_of(double y) const noexcept { return clamped((y - lower_.y) * per_m_, rows_); }
  static int clamped(double index, int count) noexcept {
    return index >= count ? count - 1 : (index > 0 ? static_cast<int>(index) : 0);  // NaN gives 0
  }
  void lay_out() noexcept;
  /// For each robot who was within reach_m when they were sorted.
  struct Lists {
    double reach_m = 0;
    bool made = false;                 // there was room for them
    std::vector<std::uint32_t> start;  // of robot n in all, and the end of the last
    std::vector<std::uint32_t> all;
  };
  void make_lists() noexcept;
  bool tell(const Lists& lists, Vector2 place, double range_m, std::size_t robot) const noexcept;
  std::span<const std::uint32_t> listed(const Lists& lists, Vector2 place, double range_m, std::size_t robot) noexcept;
  std::span<const std::uint32_t> in_cells(Vector2 place, double range_m, std::size_t robot) noexcept;

  std::vector<Disc> discs_;
  std::vector<Vector2> sorted_at_;  // where each was when it was sorted
  double moved_m_ = 0;              // the farthest that any has moved since
  double moved_squared_m2_ = 0;
  Vector2 lower_;
  double per_m_ = 1;  // cells a metre
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::uint32_t> cell_;   // of each robot
  std::vector<std::uint32_t> start_;  // of cell n in order_ at n + 1
  std::vector<std::uint32_t> order_;  // robots, cell by cell
  std::vector<std::uint32_t> found_;
  double moved_before_m_ = 0;  // moved_m_ when last asked whether to sort
  Lists touching_, seen_;
};

}  // namespace ganglion::sim
