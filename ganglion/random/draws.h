#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace ganglion {

/// Philox4x32-10: four random words as a pure function of a counter and a key.
/// Source: Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy as 1, 2, 3" (2011).
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) noexcept;

/// Names one source of chance in one run: draws depend on nothing else, so neither threads nor neighbours change them.
struct StreamId {
  std::uint64_t seed = 0;
  std::uint32_t episode = 0;
  std::uint32_t robot = 0;
  std::uint64_t component = 0;  ///< hash_name() of the component's id.
};

/// The draws of one stream at one tick, in the order they are asked for.
class Draws {
 public:
  Draws(const StreamId& stream, std::uint32_t tick) noexcept;
  /// The draws of another robot's stream at another tick, from the first.
  Draws at(std::uint32_t robot, std::uint32_t tick) const noexcept {
    Draws other = *this;
    other.counter_[1] = tick;
    other.counter_[2] = robot;
    other.draw_ = 0;
    other.foreseen_ = false;
    return other;
  }
  /// Works out the next normal of each, side by side, for streams of which nothing was drawn yet. They give the same
  /// bits as without.
  static void foresee_normals(std::span<Draws> fresh) noexcept;
  /// 64 random bits.
  std::uint64_t bits() noexcept;
  /// In [0, 1), a multiple of 2^-53.
  double uniform() noexcept;
  /// In [low, high).
  double uniform(double low, double high) noexcept { return low + (high - low) * uniform(); }
  /// In 0..count-1, count >= 1.
  std::uint32_t below(std::uint32_t count) noexcept;
  /// Standard normal: mean 0, deviation 1 (Box-Muller, one of the pair).
  double normal() noexcept;

 private:
  std::array<std::uint32_t, 2> key_;
  std::array<std::uint32_t, 4> counter_;
  std::uint32_t draw_ = 0;
  bool foreseen_ = false;
  double first_normal_ = 0;
};

}  // namespace ganglion
