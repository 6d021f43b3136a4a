#pragma once

#include "ganglion/run/prepared.h"

namespace ganglion {

/// Ticks of one run: half of what its counters hold.
inline constexpr double kMostTicks = 2147483648.0;
/// Values of the controllers of all robots together, 512 MiB.
inline constexpr double kMostRobotValues = 64.0 * (1 << 20);
/// Values that a run on open ground keeps to be compared with, 1 GiB.
inline constexpr double kMostFreeValues = 128.0 * (1 << 20);

/// How many ticks it has, at least 1; may be above kMostTicks.
double ticks_of(const Prepared& prepared) noexcept;

/// Whether frames of so many robots fit the link; else TooLarge, at `robots`. Of simulated ones that are driven here
/// nobody sends any.
void check_frames(const Prepared& prepared, Problems& problems);

/// Numbers that follow from several keys, each of them good by itself: ticks, bytes of a frame over a link, values of all
/// robots, sub-steps of a tick. What no run could carry out is told as TooLarge, at the key that a person would change.
void check_bounds(const Prepared& prepared, Problems& problems);

}  // namespace ganglion
