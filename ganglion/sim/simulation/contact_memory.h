#pragma once

#include <array>

#include "ganglion/geometry/vector2.h"

namespace ganglion::sim {

/// Tells contacts that begin from those that go on: pushing against a wall, sliding along it, standing at it, rattling.
class ContactMemory {
 public:
  void clear() noexcept { held_ = {}; }
  /// A surface with this unit normal is touched at time_s. True if no surface of about that normal (30 deg) was touched
  /// within the last kHold_s.
  bool begins(Vector2 normal, double time_s) noexcept;

 private:
  static constexpr double kHold_s = 0.1;
  static constexpr double kSameNormal = 0.866;  // cos 30 deg
  struct Held {
    Vector2 normal{};
    double until_s = -1;
  };
  std::array<Held, 4> held_{};
};

}  // namespace ganglion::sim
