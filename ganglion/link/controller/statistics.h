#pragma once

#include <cstdint>
#include <limits>

namespace ganglion::link {

/// How the link does, as one end sees it. Never part of a digest.
struct LinkStatistics {
  double round_trip_s = std::numeric_limits<double>::quiet_NaN();    ///< Of the last Act or Beat that was answered.
  double clock_offset_s = std::numeric_limits<double>::quiet_NaN();  ///< Robot's clock minus ours, from the last Beat.
  std::uint32_t reconnections = 0;
  std::uint32_t repeated = 0;  ///< Frames sent again since no answer came.
  std::uint32_t lost = 0;      ///< Packets that arrived damaged, and ticks whose Sense never came.
  std::uint32_t late = 0;      ///< Sense frames that came when they were of no use any more.
};

}  // namespace ganglion::link
