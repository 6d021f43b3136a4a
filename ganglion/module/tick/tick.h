#pragma once

#include <cstdint>

namespace ganglion {

/// The moment a component works in. Time is the application's; nothing inside a tick looks at a clock.
struct Tick {
  std::uint32_t number = 0;
  double time_s = 0;
  double step_s = 0;  ///< Until the next frame is due.
};

}  // namespace ganglion
