#pragma once

#include <string>
#include <vector>

#include "ganglion/sim/world/shape/floor.h"

namespace ganglion::sim {

/// A source of light, of sound, or of both, fixed above the ground; robots and rays pass below it. Ours.
struct Beacon {
  std::string id;
  std::string label;
  Vector2 position;
  double height_m = 0;
  double light_range_m = 0;  ///< Seen up to there where nothing stands between; 0 = dark.
  Colour colour{1, 1, 1};
  double sound_range_m = 0;  ///< Heard up to there, walls or not; 0 = silent.
  std::vector<int> word;     ///< The events it chirps one after the other, each >= 1, over and over.
  double event_s = 0;        ///< From one event of the word to the next.
  double pause_s = 0;        ///< From the end of a word to the next one's beginning.
  double start_s = 0;        ///< When the first word begins.

  /// The event that began last by time_s, and when that was; `event` 0 = none yet. A silent beacon has none.
  struct Chirp {
    int event = 0;
    double began_s = 0;
  };
  Chirp last_chirp(double time_s) const noexcept;
};

}  // namespace ganglion::sim
