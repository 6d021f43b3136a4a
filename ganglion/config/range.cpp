#include "ganglion/config/range.h"

#include <cmath>

#include "ganglion/base/text.h"

namespace ganglion::config {

Sentence text_of(const Range& range) {
  const bool low = std::isfinite(range.min), high = std::isfinite(range.max);
  if (low && high)
    return say({"in {}{}, {}]", "un número en {}{}, {}]"}, range.above_min ? "(" : "[", shortest(range.min),
               shortest(range.max));
  if (low) return Sentence::quoted(fmt::format("{} {}", range.above_min ? ">" : ">=", shortest(range.min)));
  if (high) return Sentence::quoted(fmt::format("<= {}", shortest(range.max)));
  return say({"a finite number", "un número finito"});
}

}  // namespace ganglion::config
