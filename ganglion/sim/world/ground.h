#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ganglion/base/result.h"
#include "ganglion/config/value.h"
#include "ganglion/sim/world/findings.h"
#include "ganglion/sim/world/plan/plan.h"
#include "ganglion/sim/world/ray/near_surfaces.h"
#include "ganglion/sim/world/ray/surface_grid.h"
#include "ganglion/sim/world/ray/sweep.h"

namespace ganglion::sim {

/// Immutable geometry, shared by any number of simulations and threads (std::shared_ptr<const Ground>).
class Ground {
 public:
  /// Reads `world.toml`, or a ROS map `.yaml` as it is. Every problem goes into `problems`; the first is the error.
  static Result<Ground> load(FileReader& files, int file, Problems& problems,
                             std::span<const config::Override> overrides = {});
  /// The same of a file of the disk.
  static Result<Ground> load(const std::filesystem::path& path, Problems& problems,
                             std::span<const config::Override> overrides = {});
  /// The same from a text; paths in it are relative to the folder of `file_name`.
  static Result<Ground> parse(std::string_view text, const std::string& file_name, Problems& problems);
  /// From a plan made by a program. Fails with TooLarge over the limits, with BadParameter for a spawn inside a solid.
  static Result<Ground> make(GroundPlan plan, Problems& problems);

  const std::string& name() const noexcept { return plan_.name; }
  const GroundPlan& plan() const noexcept { return plan_; }
  std::span<const MoverPlan> movers() const noexcept { return plan_.movers; }
  std::span<const Spawn> spawns() const noexcept { return plan_.spawns; }
  /// The spawn of that id, or null.
  const Spawn* spawn(std::string_view id) const noexcept;
  /// The area the file states; else the box round the map, or round everything that stands, moves or starts here.
  const Box2& bounds() const noexcept { return bounds_; }

  /// Nearest surface along a ray; movers are not part of the ground. A ray that begins inside a solid hits at range 0.
  std::optional<Hit> cast(Vector2 from, Vector2 unit_direction, double max_range_m) const noexcept;
  /// Range to the first structural surface along a ray, furniture and movers ignored [m]; +inf where there is none.
  double far_wall_m(Vector2 from, Vector2 unit_direction) const noexcept;
  /// Distance to the nearest surface, at most `up_to_m`; negative inside solids, down to -up_to_m.
  double clearance(Vector2 point, double up_to_m) const noexcept;
  /// Whether the point lies in a solid: a box, disc or polygon, or a map cell that is not free.
  bool inside_solid(Vector2 point) const noexcept;

  /// Where a disc carried along `displacement` first touches the ground: kept in `first` if earlier than what it holds.
  void sweep(Vector2 from, Vector2 displacement, double radius_m, Contact& first) const noexcept;

  const SurfaceGrid& surfaces() const noexcept { return surfaces_; }
  /// What a ray hits that is known to meet an item of the surfaces first, at that range.
  Hit hit(const Ray& ray, std::uint32_t item, double range_m) const noexcept;
  /// The lists of surfaces near each place, made at the first call.
  std::shared_ptr<const NearSurfaces> near_surfaces(double reach_m, double spread_m) const;
  /// Kept for all who use this ground; it tells nothing else than the ground does.
  Findings& findings() const noexcept { return *findings_; }

 private:
  Ground(GroundPlan plan, const Box2& bounds, SurfaceGrid surfaces);
  Hit hit(const Ray& ray, const SurfaceGrid::Found& found) const noexcept;
  GroundPlan plan_;
  Box2 bounds_;
  SurfaceGrid surfaces_;
  std::shared_ptr<Findings> findings_ = std::make_shared<Findings>();  // copies share it
};

}  // namespace ganglion::sim
