#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "ganglion/geometry/vector2.h"

namespace ganglion {

/// One layer of a map to look at, row by row from the lowest y, each value in [0, 1] or NaN where nothing is known.
struct GridLayer {
  std::string_view name;  ///< "label" (0.5 empty, 1 occupied), "risk", "static", "inhibited"
  std::span<const float> values;
};

/// A map to look at: columns x rows cells, layers over the same ground.
struct GridExhibit {
  std::string_view name;
  Vector2 origin{};  ///< Corner of the first cell [m].
  double cell_m = 1;
  int columns = 0;
  int rows = 0;
  std::span<const GridLayer> layers;
};

/// Where a component shows what it thinks: between ticks, only when somebody records or watches. It never alters the
/// run.
class Exhibition {
 public:
  virtual ~Exhibition() = default;
  virtual void grid(const GridExhibit& grid) = 0;
  /// Points in the map's frame [m], e.g. "route".
  virtual void path(std::string_view name, std::span<const Vector2> points) = 0;
};

/// What every component can do for an onlooker.
class Exhibitor {
 public:
  virtual ~Exhibitor() = default;
  virtual void show(Exhibition&) const {}
};

}  // namespace ganglion
