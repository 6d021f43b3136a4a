#include "ganglion/measure/measure.h"

namespace ganglion {

std::optional<std::size_t> MeasureScope::truth_index(std::string_view name) const noexcept {
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i].name == name) return i;
  }
  return std::nullopt;
}

}  // namespace ganglion
