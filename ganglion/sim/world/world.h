#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/geometry/pose2.h"
#include "ganglion/sim/world/ground.h"
#include "ganglion/sim/world/ray/sweep.h"

namespace ganglion::sim {

/// A mover as it stands now, for pictures.
struct MoverState {
  std::string_view id;
  std::span<const Vector2> outline;  ///< In its own frame; empty for a disc.
  double radius_m = 0;               ///< Of the disc, or of the circle round the outline.
  Pose2 pose;
};

/// A ground with the present places of its movers; one per simulation; cheap to copy. Queries and advance() neither
/// allocate nor fail; movers count as solid, not structural.
class World {
 public:
  explicit World(std::shared_ptr<const Ground> ground);

  /// Puts the movers back to their first places and fixes the draws of an episode.
  void reset(std::uint64_t seed, std::uint32_t episode) noexcept;
  /// Moves the movers through [time_s, time_s + step_s). None ever moves onto a robot: `robots` stay free; a mover on a
  /// path waits before one, and one that wants to jump while every other place is taken tries again at the next call.
  /// Draws depend on (seed, episode, mover's id, tick) only.
  void advance(std::uint32_t tick, double time_s, double step_s, std::span<const Disc> robots) noexcept;

  /// Somebody puts a mover elsewhere, its yaw as it was, between two advances. There it stays; one that strolls goes on
  /// from there (ours). Fails with BadParameter where it would overlap the ground, a robot or another mover, or lie
  /// outside of the bounds.
  Result<void> put_mover(std::size_t mover, Vector2 point, std::span<const Disc> robots);

  /// The nearest surface along a ray within max_range_m (which may be +inf). Rays touch segments at their ends and run
  /// past those they are parallel to. A ray that begins inside a solid hits at once: range 0, normal against the ray.
  std::optional<Hit> cast(Vector2 from, Vector2 unit_direction, double max_range_m) const noexcept;

  /// Of what a ray hit so far and the movers within max_range_m the nearest; `best.range_m` is +inf for nothing so far.
  Hit nearest_mover(const Ray& ray, Hit best, double max_range_m) const noexcept;

  struct Slide {
    Vector2 position;
    bool touched = false;
    Vector2 normal;  ///< Unit, away from the surface touched, the most head-on one of several.
  };
  /// Carries a disc along `displacement` up to contact, then slides the rest along the surface; corners stop it. It
  /// never ends inside a surface, however fast; along a straight wall all of the tangential displacement is kept. A
  /// disc that overlaps a surface to begin with can leave it but not go deeper. `others` are further discs in its way.
  Slide slide(Vector2 from, Vector2 displacement, double radius_m, std::span<const Disc> others = {}) const noexcept;

  /// Distance to the nearest surface, at most up_to_m; negative inside solids, down to -up_to_m.
  double clearance(Vector2 point, double up_to_m) const noexcept;

  /// Distance from a mover's surface as it stands; negative inside it.
  double mover_clearance(std::size_t mover, Vector2 point) const noexcept;

  const Ground& ground() const noexcept { return *ground_; }
  const std::shared_ptr<const Ground>& shared_ground() const noexcept { return ground_; }
  std::span<const MoverState> movers() const noexcept { return movers_; }

 private:
  /// What a mover is up to.
  struct Errand {
    double change_s = 0;     ///< Time of its next jump.
    std::size_t place = 0;   ///< Index of its present place, or of the path point it left last.
    double walked_m = 0;     ///< Way from that path point.
    std::size_t corner = 0;  ///< Index of its first corner in corners_.
    Vector2 goal;            ///< Of a stroll, while it walks.
    bool walking = false;
    double pause_s = 0;       ///< At that goal.
    double resume_s = 0;      ///< A stroll stands until then.
    std::uint32_t goals = 0;  ///< How often goals were drawn.
    bool held = false;        ///< Somebody put it where it is.
  };
  void put(std::size_t mover, const Pose2& pose) noexcept;
  void jump(std::size_t mover, std::uint32_t tick, double time_s, std::span<const Disc> robots) noexcept;
  void walk(std::size_t mover, double step_s, std::span<const Disc> robots) noexcept;
  void stroll(std::size_t mover, double time_s, double step_s, std::span<const Disc> robots) noexcept;
  /// Draws a goal to which nothing stands in the way; false if none was found.
  bool choose_goal(std::size_t mover, std::span<const Disc> robots) noexcept;
  bool free_for(std::size_t mover, const Pose2& pose, std::span<const Disc> robots) const noexcept;
  bool meets(std::size_t mover, const Pose2& pose, const Disc& robot) const noexcept;
  bool meets_ground(std::size_t mover, const Pose2& pose) const noexcept;
  bool overlaps(std::size_t mover, const Pose2& pose, std::size_t other) const noexcept;
  bool way_free(std::size_t mover, Vector2 displacement, std::span<const Disc> robots) const noexcept;
  /// Corners of a mover in the world; empty for discs.
  std::span<const Vector2> corners(std::size_t mover) const noexcept;
  Disc disc_of(std::size_t mover) const noexcept { return {movers_[mover].pose.position, movers_[mover].radius_m}; }
  double distance_to(std::size_t mover, Vector2 point) const noexcept;
  bool mover_contains(std::size_t mover, Vector2 point) const noexcept;
  std::optional<Hit> cast_mover(std::size_t mover, const Ray& ray, double max_range_m) const noexcept;
  void sweep_mover(std::size_t mover, Vector2 from, Vector2 displacement, double radius_m,
                   Contact& first) const noexcept;
  Contact first_contact(Vector2 from, Vector2 displacement, double radius_m,
                        std::span<const Disc> others) const noexcept;

  std::shared_ptr<const Ground> ground_;
  std::vector<MoverState> movers_;
  std::vector<Errand> errands_;
  std::vector<Vector2> corners_;
  std::uint64_t seed_ = 0;
  std::uint32_t episode_ = 0;
};

}  // namespace ganglion::sim
