#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace ganglion::sim {

/// Columns are read in groups of this many values, whatever the processor: theirs are padded up to a multiple of it.
inline constexpr std::size_t kLanePadding = 8;
constexpr std::size_t padded(std::size_t count) noexcept {
  return (count + kLanePadding - 1) / kLanePadding * kLanePadding;
}

/// Straight surfaces, column by column. Pads have equal ends, which no ray meets.
struct SegmentColumns {
  const double* from_x;
  const double* from_y;
  const double* to_x;
  const double* to_y;
  const double* name;  ///< What a ray that meets it is told: a whole number.
  std::size_t count;
};

/// Circles, column by column. Pads have NaN for their radius.
struct CircleColumns {
  const double* x;
  const double* y;
  const double* radius;
  const double* name;
  std::size_t count;
};

/// Rays, column by column, each with the nearest surface met so far; pads repeat a ray.
struct RayColumns {
  double* from_x;
  double* from_y;
  double* along_x;  ///< Unit directions.
  double* along_y;
  double* range_m;  ///< A surface must be nearer than this; then its range.
  double* name;     ///< Of that surface; left as it was where none is nearer.
  std::size_t count;
};

/// Rays in the frame of a robot.
struct AimColumns {
  const double* from_x;
  const double* from_y;
  const double* along_x;
  const double* along_y;
  const double* limit_m;  ///< Surfaces must be nearer than this.
};

/// Where a robot stands: its place, and the unit vector of its heading.
struct Stance {
  double x, y;
  double ahead_x, ahead_y;
};

/// What rays from one point between two directions, less than half a turn apart, may meet.
struct Wedge {
  double x, y;              ///< The point.
  double right_x, right_y;  ///< Unit; the first ray.
  double left_x, left_y;    ///< Unit; the last ray, counter-clockwise of the first.
};

/// Surfaces picked by their places in the columns.
struct Chosen {
  const std::uint32_t* places;
  std::size_t count;
};

/// Which circles a ray meets from within.
enum class Within : std::uint8_t { Seen, Unseen };

/// The same questions for several values side by side, as many as the processor takes. All forms give the same bits:
/// they are one template over the lane's type, made of operations that IEEE 754 fixes.
struct Lanes {
  const char* name;
  /// Turns rays into the world; they have met nothing yet.
  void (*aim)(const AimColumns&, const Stance&, const RayColumns&) noexcept;
  /// Rays against surfaces: all of them, or the chosen ones.
  void (*meet_segments)(const RayColumns&, const SegmentColumns&) noexcept;
  void (*meet_chosen_segments)(const RayColumns&, const SegmentColumns&, Chosen chosen) noexcept;
  void (*meet_circles)(const RayColumns&, const CircleColumns&, Within) noexcept;
  void (*meet_chosen_circles)(const RayColumns&, const CircleColumns&, Within, Chosen chosen) noexcept;
  /// One ray, whatever `count` says, against many surfaces side by side.
  void (*meet_segments_alone)(const RayColumns&, const SegmentColumns&) noexcept;
  void (*meet_circles_alone)(const RayColumns&, const CircleColumns&, Within) noexcept;
  /// Puts down the places of the surfaces that rays of the wedge may meet, and returns how many. There must be room for
  /// all and three more.
  std::size_t (*choose_segments)(const Wedge&, const SegmentColumns&, std::uint32_t* chosen) noexcept;
  std::size_t (*choose_circles)(const Wedge&, const CircleColumns&, std::uint32_t* chosen) noexcept;
};

/// The forms that this processor can run, the fastest first; the last is the plain one.
std::span<const Lanes* const> available_lanes() noexcept;
/// The one in use: the fastest, or the one that the environment variable GANGLION_LANES names when first asked.
const Lanes& lanes() noexcept;

}  // namespace ganglion::sim
