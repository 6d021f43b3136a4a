#pragma once

#include <array>

#include "ganglion/measure/measure.h"

namespace ganglion {

/// A figure that is a truth channel's last value.
struct Followed {
  std::string_view name, channel, unit;
  Text title;
};

/// Of each whose channel is known.
std::vector<Figure> followed_figures(const MeasureScope& scope, std::span<const Followed> list);
/// Reports them.
std::unique_ptr<Measure> make_followed(const MeasureScope& scope, std::span<const Followed> list);

}  // namespace ganglion
