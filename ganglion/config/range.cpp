#include "ganglion/config/range.h"

#include <fmt/format.h>

#include <cmath>

#include "ganglion/base/text.h"

namespace ganglion::config {

std::string text_of(const Range& range) {
  const bool low = std::isfinite(range.min), high = std::isfinite(range.max);
  if (low && high)
    return fmt::format("in {}{}, {}]", range.above_min ? "(" : "[", shortest(range.min), shortest(range.max));
  if (low) return fmt::format("{} {}", range.above_min ? ">" : ">=", shortest(range.min));
  if (high) return fmt::format("<= {}", shortest(range.max));
  return "a finite number";
}

}  // namespace ganglion::config
