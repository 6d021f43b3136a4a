#pragma once

#include <memory>
#include <utility>

#include "ganglion/application/terrain.h"
#include "ganglion/sim/world/ground.h"

namespace ganglion::sim {

/// The ground of simulated robots as measures and tasks see it.
class GroundTerrain final : public Terrain {
 public:
  explicit GroundTerrain(std::shared_ptr<const Ground> ground) noexcept : ground_(std::move(ground)) {}
  double far_wall_m(Vector2 from, Vector2 towards) const noexcept override {
    return ground_->far_wall_m(from, towards);
  }
  bool slopes() const noexcept override;

 private:
  std::shared_ptr<const Ground> ground_;
};

}  // namespace ganglion::sim
