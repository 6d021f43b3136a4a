#pragma once

#include <cstdint>
#include <vector>

#include "ganglion/plot/view/run_view.h"

namespace ganglion::report {

/// A learned map as the player takes it: one grid over all its extents, and what changed from frame to frame.
struct MapChanges {
  struct Frame {
    double time_s = 0;
    /// Pairs: cell (row * columns + column), then risk | inhibited << 8 | label << 16 | dynamic << 18.
    std::vector<std::uint32_t> changes;
  };
  Vector2 origin{};
  int columns = 0;
  int rows = 0;
  std::vector<Frame> frames;
};

/// The explored part of the map through the run. Frames are thinned evenly until there are at most `max_changes`
/// changed cells; the last frame always stays. Empty where nothing was explored or the grid has more than `max_cells`
/// cells.
MapChanges changes_of(const plot::MapView& map, std::size_t max_changes = 60000, std::size_t max_cells = 1u << 20);

}  // namespace ganglion::report
