#include "ganglion/sim/simulation/contact_memory.h"

#include <algorithm>

namespace ganglion::sim {

bool ContactMemory::begins(Vector2 normal, double time_s) noexcept {
  for (Held& held : held_) {
    if (held.until_s < time_s || held.normal.dot(normal) < kSameNormal) continue;
    held = {normal, time_s + kHold_s};
    return false;
  }
  auto older = [](const Held& a, const Held& b) { return a.until_s < b.until_s; };
  *std::min_element(held_.begin(), held_.end(), older) = {normal, time_s + kHold_s};
  return true;
}

}  // namespace ganglion::sim
