#include "ganglion/measure/place.h"

namespace ganglion {

std::optional<PlaceColumns> PlaceColumns::in(const MeasureScope& scope) {
  const auto x = scope.truth_index("x_m"), y = scope.truth_index("y_m"), yaw = scope.truth_index("yaw_rad");
  if (!x || !y || !yaw) return std::nullopt;
  return PlaceColumns{*x, *y, *yaw};
}

}  // namespace ganglion
