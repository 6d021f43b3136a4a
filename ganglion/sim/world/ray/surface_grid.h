#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ganglion/sim/world/ray/ray.h"
#include "ganglion/sim/world/shape/shape.h"

namespace ganglion::sim {

/// What a primitive is part of.
struct SurfaceTraits {
  Material material = Material::Rough;
  bool structural = true;
  bool solid = false;
};

/// A straight piece of surface; of solids the solid lies to the left of from -> to.
struct Segment {
  Vector2 from;
  Vector2 to;
  std::uint32_t traits = 0;  ///< Index into the traits.
};

/// A round surface.
struct RoundSurface {
  Disc disc;
  std::uint32_t traits = 0;
};

/// A solid outline as a range of segments, for point-in-solid questions.
struct SolidOutline {
  std::uint32_t first_segment = 0;
  std::uint32_t segments = 0;
};

/// All surfaces of a ground, as found.
struct SurfaceSet {
  std::vector<SurfaceTraits> traits;
  std::vector<Segment> segments;
  std::vector<RoundSurface> rounds;
  std::vector<SolidOutline> outlines;
};

/// Square cells over a rectangle; each knows the primitives that may touch it. Queries walk only the cells they need.
/// The lists are generous by kReach, so that rounding at a cell's edge never loses a surface.
class SurfaceGrid {
 public:
  explicit SurfaceGrid(SurfaceSet set);

  struct Found {
    double range_m = 0;
    Vector2 normal;
    std::uint32_t traits = 0;
    bool from_behind = false;  ///< Met from the solid's side.
  };
  /// Nearest surface along a ray up to max_range_m. `structural_only` leaves furniture out.
  std::optional<Found> cast(Vector2 from, Vector2 unit_direction, double max_range_m,
                            bool structural_only = false) const noexcept;
  /// Unsigned distance to the nearest surface, at most up_to_m.
  double distance(Vector2 point, double up_to_m) const noexcept;
  bool inside_solid(Vector2 point) const noexcept;

  /// Calls on_segment(segment) and on_round(round) for every primitive that may meet the box; some more than once.
  template <class OnSegment, class OnRound>
  void visit(const Box2& box, OnSegment on_segment, OnRound on_round) const noexcept {
    if (set_.segments.empty() && set_.rounds.empty()) return;
    const int last_column = column_of(box.upper.x), last_row = row_of(box.upper.y);
    for (int row = row_of(box.lower.y); row <= last_row; ++row) {
      for (int column = column_of(box.lower.x); column <= last_column; ++column) {
        for (const std::uint32_t item : items_in(column, row)) {
          if (item < set_.segments.size()) {
            on_segment(set_.segments[item]);
          } else {
            on_round(set_.rounds[item - set_.segments.size()]);
          }
        }
      }
    }
  }

  const SurfaceSet& set() const noexcept { return set_; }
  /// What a ray finds that meets the item at that range: segments by number, then rounds.
  Found found(const Ray& ray, std::uint32_t item, double range_m) const noexcept;
  /// What a segment's surface is like.
  struct Face {
    Vector2 along;   ///< From one end to the other.
    Vector2 normal;  ///< Unit, on the left.
    Material material = Material::Rough;
    bool solid = false;
  };
  const Face& face(std::uint32_t segment) const noexcept { return faces_[segment]; }
  const SurfaceTraits& traits(std::uint32_t index) const noexcept { return set_.traits[index]; }

 private:
  /// Lists of numbers, one for each cell, one after the other.
  struct Lists {
    std::vector<std::uint32_t> starts;
    std::vector<std::uint32_t> items;
    std::span<const std::uint32_t> of(std::size_t cell) const noexcept {
      return {items.data() + starts[cell], items.data() + starts[cell + 1]};
    }
  };
  template <class ForEach>
  Lists gather(ForEach for_each) const;
  template <class OnCell>
  void cells_of(const Segment& segment, OnCell on_cell) const;
  template <class OnCell>
  void cells_of(const RoundSurface& round, bool filled, OnCell on_cell) const;
  template <class OnCell>
  void cells_of(const Box2& box, OnCell on_cell) const;
  void choose_cells();

  int column_of(double x) const noexcept { return clamped((x - lower_.x) / cell_m_, columns_); }
  int row_of(double y) const noexcept { return clamped((y - lower_.y) / cell_m_, rows_); }
  static int clamped(double index, int count) noexcept {
    return index >= count ? count - 1 : (index > 0 ? static_cast<int>(index) : 0);  // NaN gives 0
  }
  std::size_t cell(int column, int row) const noexcept { return static_cast<std::size_t>(row) * columns_ + column; }
  std::span<const std::uint32_t> items_in(int column, int row) const noexcept { return items_.of(cell(column, row)); }
  /// The nearest item so far; of several at one range that with the lowest number.
  struct Nearest {
    double range_m;
    std::uint32_t item;
  };
  void meet(std::uint32_t item, const Ray& ray, bool structural_only, Nearest& best) const noexcept;
  double distance_to(std::uint32_t item, Vector2 point) const noexcept;

  SurfaceSet set_;
  std::vector<Face> faces_;  ///< Of the segments.
  Vector2 lower_;
  Vector2 upper_;
  double cell_m_ = 1;
  int columns_ = 1;
  int rows_ = 1;
  Lists items_;   ///< Segments, then rounds, by number.
  Lists solids_;  ///< Outlines, then rounds, by number.
};

}  // namespace ganglion::sim
