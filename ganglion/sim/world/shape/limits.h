#pragma once

#include <cstddef>

namespace ganglion::sim {

/// Limits of a world, so that a hostile or mistaken file ends in a message and not in a full memory.
inline constexpr double kMaxCoordinate_m = 10'000;
inline constexpr std::size_t kMaxSegments = 200'000;
inline constexpr std::size_t kMaxDiscs = 20'000;
inline constexpr std::size_t kMaxMovers = 1'000;
inline constexpr std::size_t kMaxSpawns = 10'000;
inline constexpr std::size_t kMaxPolygonPoints = 1'000;
inline constexpr std::size_t kMaxFloorItems = 1'000;  ///< Zones; straight pieces of bumps.
inline constexpr std::size_t kMaxBeacons = 100;
inline constexpr std::size_t kMaxWord = 100;  ///< Events of one word.
/// Nothing may be smaller, and neighbouring points may not lie closer.
inline constexpr double kMinSize_m = 1e-4;

}  // namespace ganglion::sim
