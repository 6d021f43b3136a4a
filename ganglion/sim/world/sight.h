#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "ganglion/sim/world/ray/near_surfaces.h"
#include "ganglion/sim/world/ray/ray_fan.h"
#include "ganglion/sim/world/world.h"

namespace ganglion::sim {

/// All that one robot can see at one moment, gathered once for all of its rays: surfaces near it, movers, other robots.
/// Gives what World::cast() and the discs of the others give, ray by ray, the same bits on every processor. Of surfaces
/// at the very same range one that stands on the ground hides a robot, else the first in order.
class Sight {
 public:
  /// For robots whose rays begin at most spread_m from their centre and, mirrored ways included, are at most reach_m
  /// long. `robots`: most others in sight. Takes all its memory.
  Sight(const std::shared_ptr<const Ground>& ground, double reach_m, double spread_m, std::size_t robots,
        const Lanes& lanes = sim::lanes());

  /// Looks round from a place, where there are these other robots.
  void look(const World& world, Vector2 centre, std::span<const Disc> others) noexcept;

  /// Casts a group of rays from the robot, which stands there and outside all solids.
  void cast(RayFan& fan, std::size_t group, Vector2 position, Vector2 ahead) noexcept;
  /// What a ray of the fan met when its group was cast, as long as nobody looks elsewhere.
  Hit hit(const RayFan& fan, std::size_t place) const noexcept;
  /// How a ray of the fan, which met something, fell on that.
  struct Incidence {
    double cosine = 1;  ///< Between the ray and the surface's normal, both ways the same.
    Material material = Material::Rough;
  };
  Incidence incidence(const RayFan& fan, std::size_t place) const noexcept;
  /// One ray from anywhere; the way that led there included, it may not end farther off than stated.
  Hit cast(const Ray& ray, double max_range_m) noexcept;
  /// Whether a ray from there of that length stays within what was gathered.
  bool covers(Vector2 from, double range_m) const noexcept;

 private:
  // What rays are told of what they meet: the place in its columns, from these numbers up.
  static constexpr double kRounds = 1 << 12, kOthers = 1 << 13, kWalked = 1 << 30;

  struct Columns {
    explicit Columns(std::size_t rows) : a(padded(rows)), b(a), c(a), d(a), name(a) {}
    std::vector<double> a, b, c, d, name;
    std::size_t count = 0;
  };
  void add_segments(std::span<const std::uint32_t> items) noexcept;
  void put_others(std::span<const Disc> others) noexcept;
  SegmentColumns segments(std::size_t count) const noexcept;
  CircleColumns circles(const Columns& columns) const noexcept;
  void meet(const RayColumns& rays) const noexcept;
  void meet(const RayColumns& rays, const Wedge& wedge) noexcept;
  void walk(const RayColumns& rays, Hit* hits) const noexcept;
  Hit fixed_hit(const Ray& ray, double range_m, double name, const Hit& walked) const noexcept;
  Hit seen(const Ray& ray, double range_m, double name, const Hit& walked) const noexcept;

  std::shared_ptr<const Ground> ground_;
  std::shared_ptr<const NearSurfaces> near_;
  const Lanes* lanes_;
  const World* world_ = nullptr;
  double covered_m_;
  Vector2 centre_;
  bool listed_ = false;
  std::size_t facing_ = 0;                        // the first segments; only mirrored rays look at the others
  Columns segments_;                              // from x, from y, to x, to y
  Columns rounds_, others_;                       // x, y, radius
  std::vector<std::uint32_t> item_, round_item_;  // their numbers on the ground
  std::span<const std::uint32_t> averted_;        // segments still to be added, once a mirrored ray is cast
  std::vector<std::uint32_t> chosen_;
};

inline Sight::Incidence Sight::incidence(const RayFan& fan, std::size_t place) const noexcept {
  const Vector2 along{fan.along_x_[place], fan.along_y_[place]};
  if (const double name = fan.name_[place]; name < kRounds) {
    const SurfaceGrid::Face& face = ground_->surfaces().face(item_[static_cast<std::size_t>(name)]);
    const double cosine = face.normal.dot(along);
    if (cosine >= 0 || !face.solid) return {std::fabs(cosine), face.material};
  }
  const Hit met = hit(fan, place);  // round, moving, or left from within a solid
  return {-met.normal.dot(along), met.material};
}

}  // namespace ganglion::sim
