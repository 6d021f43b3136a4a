#pragma once

#include <cstdint>
#include <vector>

#include "ganglion/grid/way/cell_grid.h"

namespace ganglion {

/// Shortest ways on a CellGrid for a robot that cannot turn on the spot. A step forwards leaves it heading where it
/// travelled, a step backwards the opposite way; neither may change the heading by more than `max_turn` eighths of a
/// full turn. Headings are eighths counter-clockwise from x, 0..7. The robot may stop with any heading.
///
/// Memory    17 bytes for each cell and heading, taken in make(); a search allocates nothing.
/// Source    Dijkstra (1959) over cells x headings. Ours: as steps have two lengths only, two queues, each in order of
///           length by itself, do a heap's work.
class SteeredWay {
 public:
  using Cell = CellGrid::Cell;

  /// Fails with BadParameter unless max_turn is 1, 2 or 4, with TooLarge beyond 1 Mi cells.
  static Result<SteeredWay> make(const CellGrid& grid, int max_turn);

  /// Length of a shortest way [m], octile as in CellGrid::shortest_m(); +inf if there is none. The grid must be as
  /// large as the one given to make(), the heading in 0..7.
  double shortest_m(const CellGrid& grid, Cell from, int heading, Cell to) noexcept;

 private:
  /// Counts and not sums, so that the length never depends on the order of the steps.
  struct Length {
    std::uint32_t straight = 0;
    std::uint32_t diagonal = 0;
    double cells() const noexcept;
  };
  /// First in, first out; a state enters each queue once at most.
  struct Queue {
    std::vector<std::uint32_t> states;
    std::size_t head = 0;
    std::size_t tail = 0;
    bool empty() const noexcept { return head == tail; }
    std::uint32_t front() const noexcept { return states[head]; }
    void push(std::uint32_t state) noexcept { states[tail++] = state; }
  };
  enum class Mark : std::uint8_t { Unseen, Open, Closed };

  SteeredWay(std::size_t cells, int max_turn);
  void clear() noexcept;
  /// The open state with the shortest way; of two equal ones that of the straight step. Not both queues may be empty.
  std::uint32_t pop() noexcept;
  /// Opens what one step leads to from a state in `cell`.
  void expand(const CellGrid& grid, std::uint32_t state, Cell cell) noexcept;
  void open(std::uint32_t state, const Length& before, bool diagonal) noexcept;

  int max_turn_;
  std::vector<Length> length_;  // of the way by which a state was opened last
  std::vector<Mark> mark_;
  Queue straight_;  // states opened by straight steps, by diagonal ones
  Queue diagonal_;
};

}  // namespace ganglion
