#include "ganglion/sim/simulation/neighbours.h"

#include <algorithm>
#include <cmath>

namespace ganglion::sim {
namespace {

constexpr double kCell_m = 1;
constexpr std::size_t kCellsPerDisc = 8;  // where the discs are spread wide, cells are larger

constexpr double kListRounding_m = 1e-9;
constexpr std::size_t kFew = 32;
constexpr double kSkin_m = 0.3;              // lists serve until somebody has moved so far
constexpr std::size_t kListedPerRobot = 64;  // on the average; where robots are denser there are no lists

/// Numbers that come row by row and are few as a rule.
void put_in_order(std::vector<std::uint32_t>& numbers) noexcept {
  if (numbers.size() > kFew) return std::sort(numbers.begin(), numbers.end());
  for (std::size_t n = 1; n < numbers.size(); ++n) {
    const std::uint32_t number = numbers[n];
    std::size_t at = n;
    for (; at > 0 && numbers[at - 1] > number; --at) numbers[at] = numbers[at - 1];
    numbers[at] = number;
  }
}

}  // namespace

void Neighbours::make_room(std::size_t robots, double touch_m, double sight_m) {
  discs_.resize(robots);
  sorted_at_.resize(robots);
  cell_.resize(robots);
  order_.resize(robots);
  found_.reserve(robots);
  touching_.reach_m = touch_m + 2 * kSkin_m;
  seen_.reach_m = sight_m + 2 * kSkin_m;
  for (Lists* lists : {&touching_, &seen_}) {
    lists->start.resize(robots + 1);
    lists->all.resize(kListedPerRobot * robots);
  }
  start_.resize(kCellsPerDisc * robots + 2);
}

void Neighbours::put(std::size_t robot, const Disc& disc) noexcept {
  discs_[robot] = disc;
  const double squared_m2 = (disc.position - sorted_at_[robot]).squared();
  if (squared_m2 <= moved_squared_m2_) return;
  moved_squared_m2_ = squared_m2;
  moved_m_ = std::sqrt(squared_m2);
}

void Neighbours::lay_out() noexcept {
  Box2 box = empty_box();
  for (const Disc& disc : discs_) box.include(disc.position);
  const double most = static_cast<double>(kCellsPerDisc * discs_.size());
  auto along = [](double length_m, double cell_m) { return std::floor(length_m / cell_m) + 1; };
  double cell_m = kCell_m;
  while (along(box.width_m(), cell_m) * along(box.height_m(), cell_m) > most) cell_m *= 1.5;
  lower_ = box.lower;
  per_m_ = 1 / cell_m;
  columns_ = static_cast<int>(along(box.width_m(), cell_m));
  rows_ = static_cast<int>(along(box.height_m(), cell_m));
}

void Neighbours::sort_if_needed() noexcept {
  const double next_m = moved_m_ + (moved_m_ - moved_before_m_);
  moved_before_m_ = moved_m_;
  if (!seen_.made || !(next_m <= kSkin_m)) sort();
}

void Neighbours::sort() noexcept {
  moved_m_ = moved_squared_m2_ = moved_before_m_ = 0;
  if (discs_.size() < 2) return;
  lay_out();
  const std::size_t cells = static_cast<std::size_t>(columns_) * rows_;
  std::fill_n(start_.begin(), cells + 2, 0);
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    sorted_at_[i] = discs_[i].position;
    cell_[i] = static_cast<std::uint32_t>(row_of(sorted_at_[i].y) * columns_ + column_of(sorted_at_[i].x));
    ++start_[cell_[i] + 1];
  }
  for (std::size_t cell = 1; cell < cells + 2; ++cell) start_[cell] += start_[cell - 1];
  for (std::size_t i = discs_.size(); i-- > 0;) order_[--start_[cell_[i] + 1]] = static_cast<std::uint32_t>(i);
  make_lists();
}

void Neighbours::make_lists() noexcept {
  touching_.made = seen_.made = false;
  std::uint32_t touch = 0, see = 0;
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    const auto near = in_cells(sorted_at_[i], seen_.reach_m, i);
    if (near.size() > seen_.all.size() - see) return;
    touching_.start[i] = touch;
    seen_.start[i] = see;
    for (const std::uint32_t other : near) {
      seen_.all[see++] = touching_.all[touch] = other;
      touch += (discs_[other].position - discs_[i].position).squared() <= touching_.reach_m * touching_.reach_m ? 1 : 0;
    }
  }
  touching_.start.back() = touch;
  seen_.start.back() = see;
  touching_.made = seen_.made = true;
}

bool Neighbours::tell(const Lists& lists, Vector2 place, double range_m, std::size_t robot) const noexcept {
  const double slack_m = lists.reach_m - range_m - moved_m_ - kListRounding_m;
  return lists.made && slack_m >= 0 && (place - sorted_at_[robot]).squared() <= slack_m * slack_m;
}

std::span<const std::uint32_t> Neighbours::within(Vector2 place, double range_m, std::size_t robot) noexcept {
  if (tell(touching_, place, range_m, robot)) return listed(touching_, place, range_m, robot);
  if (tell(seen_, place, range_m, robot)) return listed(seen_, place, range_m, robot);
  return in_cells(place, range_m, robot);
}

std::span<const std::uint32_t> Neighbours::listed(const Lists& lists, Vector2 place, double range_m,
                                                  std::size_t robot) noexcept {
  const std::span list(&lists.all[lists.start[robot]], lists.start[robot + 1] - lists.start[robot]);
  if (found_.size() < list.size()) found_.resize(list.size());  // within what is reserved; never smaller: it is rare
  const Disc* discs = discs_.data();
  std::uint32_t* found = found_.data();
  std::size_t count = 0;
  for (const std::uint32_t other : list) {
    found[count] = other;
    count += (discs[other].position - place).squared() <= range_m * range_m ? 1 : 0;
  }
  return std::span(found_).first(count);
}

std::span<const std::uint32_t> Neighbours::in_cells(Vector2 place, double range_m, std::size_t left_out) noexcept {
  found_.clear();
  if (discs_.size() < 2) return found_;
  const double reach_m = range_m + moved_m_ + kListRounding_m;
  const int left = column_of(place.x - reach_m), right = column_of(place.x + reach_m);
  const int top = row_of(place.y + reach_m);
  for (int row = row_of(place.y - reach_m); row <= top; ++row) {
    const std::uint32_t* start = &start_[static_cast<std::size_t>(row) * columns_ + 1];
    for (std::uint32_t n = start[left]; n < start[right + 1]; ++n) {
      const std::uint32_t robot = order_[n];
      if (robot == left_out || !((discs_[robot].position - place).squared() <= range_m * range_m)) continue;
      found_.push_back(robot);
    }
  }
  put_in_order(found_);
  return found_;
}

}  // namespace ganglion::sim
