#include "ganglion/grid/router.h"

#include <algorithm>

#include "ganglion/base/expects.h"

namespace ganglion::grid {
namespace {

constexpr std::uint32_t cell_of(std::uint32_t state) noexcept { return state / kDirections; }
constexpr int heading_of(std::uint32_t state) noexcept { return static_cast<int>(state % kDirections); }
constexpr std::uint32_t state_of(std::uint32_t cell, int heading) noexcept {
  return cell * kDirections + static_cast<std::uint32_t>(heading);
}
constexpr int heading_for(int direction, Motion motion) noexcept {
  return motion == Motion::Forward ? direction : turned(direction, 4);
}

/// How a state was reached, in one byte.
constexpr std::uint8_t packed(int direction, int heading_before, Motion motion) noexcept {
  return static_cast<std::uint8_t>(direction | heading_before << 3 | (motion == Motion::Backward ? 64 : 0));
}
constexpr int direction_in(std::uint8_t arrival) noexcept { return arrival & 7; }
constexpr int heading_before_in(std::uint8_t arrival) noexcept { return (arrival >> 3) & 7; }
constexpr Motion motion_in(std::uint8_t arrival) noexcept {
  return (arrival & 64) != 0 ? Motion::Backward : Motion::Forward;
}

}  // namespace

Router::Router(const RouterRule& rule)
    : rule_(rule),
      distance_(rule.window_cells),
      states_(distance_.cells() * kDirections),
      open_(states_.size()),
      backward_extra_(static_cast<std::uint64_t>((rule.backward_weight - 1) * 256 + 0.5)) {
  expects(rule.max_turn == 1 || rule.max_turn == 2 || rule.max_turn == 4);
  expects(rule.backward_weight >= 1 && rule.backward_weight <= 100);
  route_.reserve(kLongestRoute);
}

Router::State& Router::meet(std::uint32_t state) noexcept {
  State& met = states_[state];
  if (met.met != search_) {
    met = {kNever, search_, 0};
    open_.meet(state);
  }
  return met;
}

void Router::begin_search() noexcept {
  if (++search_ == 0) {
    for (State& state : states_) state.met = 0;
    search_ = 1;
  }
  open_.clear();
  route_.clear();
  cost_ = kNever;
}

Router::Outcome Router::find(const Pricing& pricing, CellIndex start, int heading, CellIndex goal) noexcept {
  begin_search();
  if (!distance_.aim(pricing, start, goal)) return Outcome::TooFar;
  const std::uint32_t first = distance_.number(start);
  const std::uint32_t last = distance_.number(goal);
  if (distance_(first) == kNever) return Outcome::None;
  const std::uint32_t start_state = state_of(first, heading);
  meet(start_state).cost = 0;
  open_.push(start_state, 0);
  while (!open_.empty()) {
    const std::uint32_t state = open_.pop();
    if (cell_of(state) == last) {
      cost_ = states_[state].cost;
      trace(start_state, state);
      return Outcome::Found;
    }
    expand(state);
  }
  return Outcome::None;
}

void Router::expand(std::uint32_t state) noexcept {
  const int heading = heading_of(state);
  if (rule_.max_turn == 4) {
    for (int k = 0; k < kDirections; ++k) reach(state, k, Motion::Forward);
    return;  // who turns on the spot never needs to back
  }
  for (int turn = -rule_.max_turn; turn <= rule_.max_turn; ++turn) {
    reach(state, turned(heading, turn), Motion::Forward);
    reach(state, turned(heading, turn + 4), Motion::Backward);
  }
}

void Router::reach(std::uint32_t from, int direction, Motion motion) noexcept {
  const std::uint32_t cell = cell_of(from);
  const std::uint32_t edge = distance_.step(cell, direction);
  if (edge == kNever) return;
  const std::uint32_t entered = distance_.next(cell, direction);
  const std::uint32_t state = state_of(entered, heading_for(direction, motion));
  State& reached = meet(state);
  if (open_.closed(state)) return;
  std::uint64_t cost = std::uint64_t{states_[from].cost} + edge;
  if (motion == Motion::Backward) cost += distance_.length(entered, direction) * backward_extra_ / 256;
  if (cost >= reached.cost) return;
  const std::uint32_t ahead = distance_(entered);
  if (ahead == kNever || cost + ahead >= kNever) return;
  reached.cost = static_cast<std::uint32_t>(cost);
  reached.arrival = packed(direction, heading_of(from), motion);
  open_.push(state, (cost + ahead) << 32 | ahead);
}

void Router::trace(std::uint32_t start, std::uint32_t end) noexcept {
  const auto before = [this](std::uint32_t state) {
    const std::uint8_t arrival = states_[state].arrival;
    return state_of(distance_.next(cell_of(state), turned(direction_in(arrival), 4)), heading_before_in(arrival));
  };
  std::size_t length = 0;
  for (std::uint32_t state = end; state != start; state = before(state)) ++length;
  route_.resize(std::min(length, kLongestRoute));
  for (std::uint32_t state = end; state != start; state = before(state)) {
    if (--length >= route_.size()) continue;
    const std::uint8_t arrival = states_[state].arrival;
    route_[length] = {motion_in(arrival), static_cast<std::uint8_t>(direction_in(arrival)),
                      static_cast<std::uint8_t>(heading_of(state)), distance_.index(cell_of(before(state))),
                      distance_.index(cell_of(state))};
  }
}

}  // namespace ganglion::grid
