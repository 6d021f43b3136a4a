#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ganglion/sim/simulation/neighbours.h"
#include "ganglion/sim/world/world.h"

namespace ganglion::sim {

/// Robots that come together within a sub-step, and how far they push each other. Ours:
///
/// Wheels and tracks pull a body towards the way its drive wants, all of them alike, with a force that grows with the
/// slip between wanted and true way; those of a standing robot want no way and pull as much. Bodies have no inertia and
/// touch without friction. Hence the true ways are, in the sense of least squares, the nearest to the wanted ones on
/// which no two bodies and no body and wall overlap: two that push head-on stand, a robot that pushes a standing one
/// goes half as fast as it would alone and so does the other, in whatever direction they face; at a wall both stand;
/// n in a row with one that pushes go at a n-th. Rows of more than some ten robots get somewhat less evenly shared.
///
/// What comes out does not depend on the order of the robots but for rounding, and nothing ever overlaps.
class Crowd {
 public:
  /// All bodies are discs of that radius. Where a push does not move a drive (Drive::yields()), they only block.
  Crowd(double radius_m, bool yields) noexcept : radius_m_(radius_m), yields_(yields) {}
  void make_room(std::size_t robots);

  /// What a robot wants of a sub-step.
  struct Wish {
    Vector2 way{};
    double room_m = 0;  ///< No surface of the ground is nearer to its body than this, as far as is known.
  };
  /// A sub-step begins in which the robots in `busy` have those wishes (by robot); the others stand fast.
  void gather(Neighbours& all, std::span<const std::size_t> busy, std::span<const Wish> wishes) noexcept;
  /// Those who have others near enough to meet; all other busy robots meet nobody in this sub-step.
  std::span<const std::uint32_t> members() const noexcept { return members_; }
  bool has(std::size_t robot) const noexcept { return member_[robot] != 0; }
  /// Carries the members to where they get, in `all`.
  void push(const World& world, Neighbours& all) noexcept;

  /// A body pressed against a wall or another body.
  struct Press {
    std::uint32_t robot = 0;
    bool wall = false;     ///< Or a mover; else another robot.
    Vector2 normal{};      ///< Away from what it touches.
    double closing_m = 0;  ///< By how much the two would have come closer in the sub-step, along the normal.
  };
  std::span<const Press> presses() const noexcept { return presses_; }
  bool pressed(std::size_t robot) const noexcept { return pressed_[robot] != 0; }

 private:
  /// Two bodies, or a body and a wall, that keep a distance: normal * (way - way of the other) + gap_m >= 0.
  struct Meeting {
    std::uint32_t robot = 0;
    std::uint32_t other = 0;
    bool other_stands = true;  // a wall, or a robot that has gone its way
    bool wall = false;
    bool active = false;
    Vector2 normal{};
    double gap_m = 0;
    double closing_m = 0;
    double push_m = 0;
    std::uint32_t next_wall = 0;  // of the same robot, as index + 1; 0 = none
  };
  bool activate(const Neighbours& all) noexcept;
  bool find_walls(const World& world, const Neighbours& all) noexcept;
  bool knows_wall(std::size_t robot, Vector2 normal) const noexcept;
  void solve() noexcept;
  double mend(Meeting& meeting) noexcept;
  void carry(const World& world, Neighbours& all) noexcept;
  bool carry(std::size_t robot, const World& world, Neighbours& all) noexcept;
  void press_wall(std::size_t robot, const World::Slide& slide) noexcept;
  World::Slide slide(std::size_t robot, const World& world, Neighbours& all) noexcept;
  void list_presses() noexcept;
  Vector2 way_between(const Meeting& meeting) const noexcept;

  double radius_m_;
  bool yields_;
  std::vector<Vector2> way_;  // of every robot: wanted at first, in the end true
  std::vector<double> room_m_;
  std::vector<std::uint32_t> first_wall_;  // of each member, as index in meetings_ + 1; 0 = none
  std::vector<char> busy_, member_, engaged_, pressed_;
  std::vector<std::uint32_t> members_;
  std::vector<Meeting> meetings_;
  std::vector<Press> presses_;
  std::vector<Disc> near_;  // in one robot's way
};

}  // namespace ganglion::sim
