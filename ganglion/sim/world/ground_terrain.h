#pragma once

#include <memory>
#include <utility>

#include "ganglion/application/terrain.h"
#include "ganglion/sim/world/world.h"

namespace ganglion::sim {

/// The ground of simulated robots as measures and tasks see it, with what moves on it where a world is given.
class GroundTerrain final : public Terrain {
 public:
  /// `world` outlives it.
  explicit GroundTerrain(std::shared_ptr<const Ground> ground, const World* world = nullptr) noexcept
      : ground_(std::move(ground)), world_(world) {}
  Box2 bounds() const noexcept override { return ground_->bounds(); }
  double far_wall_m(Vector2 from, Vector2 towards) const noexcept override {
    return ground_->far_wall_m(from, towards);
  }
  bool slopes() const noexcept override;
  double clearance_m(Vector2 point, double up_to_m) const noexcept override {
    return ground_->clearance(point, up_to_m);
  }
  bool way_free(Vector2 from, Vector2 way, double radius_m) const noexcept override;
  std::size_t movers() const noexcept override { return world_ != nullptr ? world_->movers().size() : 0; }
  Mover mover(std::size_t n) const noexcept override {
    return {world_->movers()[n].pose.position, world_->movers()[n].radius_m};
  }
  double mover_clearance_m(std::size_t n, Vector2 point) const noexcept override {
    return world_->mover_clearance(n, point);
  }

 private:
  std::shared_ptr<const Ground> ground_;
  const World* world_;
};

}  // namespace ganglion::sim
