#include "ganglion/sim/world/world.h"

#include <algorithm>

#include "ganglion/base/expects.h"

namespace ganglion::sim {
namespace {

/// Contacts leave this gap, so that rounding neither puts a body into a surface nor makes one that slides along a wall
/// stumble over the joints of its pieces; the gap is looked for at half its width. Ours.
constexpr double kSkin_m = 1e-9;
constexpr int kMaxBends = 24;   ///< Surfaces touched in one slide: a staircase of map cells has many.
constexpr int kMaxStalled = 4;  ///< Contacts in a row without getting anywhere: a corner.

bool finite(Vector2 v) noexcept { return std::isfinite(v.x) && std::isfinite(v.y); }

}  // namespace

World::World(std::shared_ptr<const Ground> ground) : ground_(std::move(ground)) {
  expects(ground_ != nullptr);
  for (const MoverPlan& plan : ground_->movers()) {
    errands_.push_back({.corner = corners_.size()});
    corners_.resize(corners_.size() + plan.outline.size());
    movers_.push_back({plan.id, plan.outline, plan.radius_m, Pose2{}});
  }
  reset(0, 0);
}

std::optional<Hit> World::cast(Vector2 from, Vector2 unit_direction, double max_range_m) const noexcept {
  const Ray ray{from, unit_direction};
  const std::optional<Hit> fixed = ground_->cast(from, unit_direction, max_range_m);
  if (movers_.empty()) return fixed;
  const Hit none{kNoHit, {}, Material::Rough};
  const Hit best = nearest_mover(ray, fixed.value_or(none), fixed ? fixed->range_m : max_range_m);
  return fixed || best.range_m < kNoHit ? std::optional(best) : std::nullopt;
}

Hit World::nearest_mover(const Ray& ray, Hit best, double max_range_m) const noexcept {
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    if (range_to_circle(ray, disc_of(i)) == kNoHit) continue;
    const auto hit = cast_mover(i, ray, std::min(best.range_m, max_range_m));
    if (hit && hit->range_m < best.range_m) best = *hit;
  }
  return best;
}

std::optional<Hit> World::cast_mover(std::size_t mover, const Ray& ray, double max_range_m) const noexcept {
  const Material material = ground_->movers()[mover].material;
  if (mover_contains(mover, ray.from)) return Hit{0, -ray.direction, material};
  const auto outline = corners(mover);
  if (outline.empty()) {
    const double range = range_to_circle(ray, disc_of(mover));
    if (!(range <= max_range_m)) return std::nullopt;
    return Hit{range, normal_towards(ray, disc_of(mover), range), material};
  }
  Hit hit{kNoHit, {}, material};
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vector2 a = outline[k], b = outline[(k + 1) % outline.size()];
    const double range = range_to_segment(ray, a, b);
    if (range < hit.range_m) hit = {range, normal_towards(ray, a, b), material};
  }
  return hit.range_m < kNoHit && hit.range_m <= max_range_m ? std::optional<Hit>(hit) : std::nullopt;
}

Contact World::first_contact(Vector2 from, Vector2 displacement, double radius_m,
                             std::span<const Disc> others) const noexcept {
  Contact first;
  ground_->sweep(from, displacement, radius_m, first);
  for (std::size_t i = 0; i < movers_.size(); ++i) sweep_mover(i, from, displacement, radius_m, first);
  for (const Disc& other : others) sweep_disc(from, displacement, radius_m, other, first);
  return first;
}

World::Slide World::slide(Vector2 from, Vector2 displacement, double radius_m,
                          std::span<const Disc> others) const noexcept {
  Slide slide{from, false, {}};
  if (!finite(from) || !finite(displacement)) return slide;
  Vector2 rest = displacement;
  double head_on = kNoHit;
  int stalled = 0;
  for (int bend = 0; bend < kMaxBends && stalled < kMaxStalled && rest.squared() > 0; ++bend) {
    const Contact contact = first_contact(slide.position, rest, radius_m + kSkin_m / 2, others);
    if (!contact.happened()) {
      slide.position += rest;
      break;
    }
    const Vector2 advance = rest * contact.fraction;
    slide.position += advance;
    const Vector2 push = contact.normal * std::min(contact.depth_m + kSkin_m / 2, kSkin_m);
    if (!first_contact(slide.position, push, radius_m, others).happened()) slide.position += push;
    if (const double approach = displacement.dot(contact.normal); approach < head_on) {
      head_on = approach;
      slide.normal = contact.normal;
    }
    slide.touched = true;
    stalled = advance.squared() > kSkin_m * kSkin_m ? 0 : stalled + 1;
    rest = rest * (1 - contact.fraction);
    rest = rest - contact.normal * rest.dot(contact.normal);
    if (rest.squared() <= 1e-24 * displacement.squared()) break;  // head-on: what is left is rounding
  }
  return slide;
}

double World::clearance(Vector2 point, double up_to_m) const noexcept {
  double clearance_m = ground_->clearance(point, up_to_m);
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    const Vector2 away = point - movers_[i].pose.position;
    if (away.length() - movers_[i].radius_m >= std::fabs(clearance_m)) continue;
    const double distance_m = std::min(distance_to(i, point), up_to_m);
    if (mover_contains(i, point)) {
      clearance_m = std::min(clearance_m, -distance_m);
    } else if (clearance_m > 0) {
      clearance_m = std::min(clearance_m, distance_m);
    }
  }
  return clearance_m;
}

}  // namespace ganglion::sim
