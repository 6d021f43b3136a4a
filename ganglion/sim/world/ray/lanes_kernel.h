// The bodies of Lanes over a lane type V: double, or a vector of doubles (GCC's vector extensions, whose comparisons
// and ?: work lane by lane). Included by one source file for each V, compiled for its processor: everything is in an
// anonymous namespace, and nothing inline of other headers may be called, lest the linker take that processor's copy of
// it for the whole program. Each file provides `V root(V)`, and `unsigned signs(mask)` with a bit for each lane in which
// a comparison of V came true.
#include <algorithm>
#include <array>
#include <cstring>

#include "ganglion/sim/world/ray/lanes.h"

namespace ganglion::sim {
namespace {

constexpr double kWedgeMargin_m = 1e-9;  // by which choosing is generous: rounding must not lose a surface

template <class V>
constexpr std::size_t kWidth = sizeof(V) / sizeof(double);

template <class V>
[[gnu::always_inline]] inline V load(const double* from) noexcept {
  V values;
  std::memcpy(&values, from, sizeof(V));
  return values;
}
template <class V>
[[gnu::always_inline]] inline void store(V values, double* to) noexcept {
  std::memcpy(to, &values, sizeof(V));
}
/// The same value in all lanes; minus 0 stays minus 0.
template <class V>
[[gnu::always_inline]] inline V all(double value) noexcept {
  return value - V{};
}

/// Rays, or one ray in all lanes.
template <class V>
struct RayLanes {
  V from_x, from_y, along_x, along_y, range_m, name;
};
template <class V>
[[gnu::always_inline]] inline RayLanes<V> rays_at(const RayColumns& rays, std::size_t at) noexcept {
  return {load<V>(rays.from_x + at),  load<V>(rays.from_y + at),  load<V>(rays.along_x + at),
          load<V>(rays.along_y + at), load<V>(rays.range_m + at), load<V>(rays.name + at)};
}
template <class V>
[[gnu::always_inline]] inline RayLanes<V> first_ray(const RayColumns& rays) noexcept {
  return {all<V>(rays.from_x[0]),  all<V>(rays.from_y[0]),  all<V>(rays.along_x[0]),
          all<V>(rays.along_y[0]), all<V>(rays.range_m[0]), all<V>(rays.name[0])};
}

template <class V, class Nearer>
[[gnu::always_inline]] inline void keep(RayLanes<V>& ray, Nearer nearer, V range_m, V name) noexcept {
  ray.range_m = nearer ? range_m : ray.range_m;
  ray.name = nearer ? name : ray.name;
}

/// range_to_segment() of ray.h.
template <class V>
[[gnu::always_inline]] inline void meet_segment(RayLanes<V>& ray, V from_x, V from_y, V to_x, V to_y, V name) noexcept {
  const V ax = from_x - ray.from_x, ay = from_y - ray.from_y, bx = to_x - ray.from_x, by = to_y - ray.from_y;
  const V side_a = ray.along_x * ay - ray.along_y * ax, side_b = ray.along_x * by - ray.along_y * bx;
  const V along_a = ray.along_x * ax + ray.along_y * ay, along_b = ray.along_x * bx + ray.along_y * by;
  const V share = side_a / (side_a - side_b);
  const V range_m = along_a + (along_b - along_a) * share;
  keep(ray, (share >= 0) & (share <= 1) & (range_m >= 0) & (range_m < ray.range_m), range_m, name);
}

/// range_to_circle() of ray.h.
template <Within within, class V>
[[gnu::always_inline]] inline void meet_circle(RayLanes<V>& ray, V x, V y, V radius, V name) noexcept {
  const V to_x = x - ray.from_x, to_y = y - ray.from_y;
  const V along = ray.along_x * to_x + ray.along_y * to_y, aside = ray.along_x * to_y - ray.along_y * to_x;
  const V squared = (radius - aside) * (radius + aside);
  const auto met = squared >= 0;
  const V half_chord = root(met ? squared : V{});
  const V near_m = along - half_chord;
  V range_m = near_m;
  if constexpr (within == Within::Seen) range_m = near_m >= 0 ? near_m : along + half_chord;
  keep(ray, met & (range_m >= 0) & (range_m < ray.range_m), range_m, name);
}

template <class V>
[[gnu::always_inline]] inline void meet_nth(RayLanes<V>& ray, const SegmentColumns& s, std::size_t n) noexcept {
  meet_segment(ray, all<V>(s.from_x[n]), all<V>(s.from_y[n]), all<V>(s.to_x[n]), all<V>(s.to_y[n]), all<V>(s.name[n]));
}
template <Within within, class V>
[[gnu::always_inline]] inline void meet_nth(RayLanes<V>& ray, const CircleColumns& c, std::size_t n) noexcept {
  meet_circle<within>(ray, all<V>(c.x[n]), all<V>(c.y[n]), all<V>(c.radius[n]), all<V>(c.name[n]));
}

/// Calls meet(ray lanes) for every group of rays.
template <class V, class Meet>
[[gnu::always_inline]] inline void each_group(const RayColumns& rays, Meet meet) noexcept {
  for (std::size_t at = 0; at < rays.count; at += kWidth<V>) {
    RayLanes<V> ray = rays_at<V>(rays, at);
    meet(ray);
    store(ray.range_m, rays.range_m + at);
    store(ray.name, rays.name + at);
  }
}

/// Turns rays from the robot's frame into the world's.
template <class V>
void aim(const AimColumns& aims, const Stance& stance, const RayColumns& rays) noexcept {
  const V x = all<V>(stance.x), y = all<V>(stance.y), ahead_x = all<V>(stance.ahead_x),
          ahead_y = all<V>(stance.ahead_y);
  for (std::size_t at = 0; at < rays.count; at += kWidth<V>) {
    const V mount_x = load<V>(aims.from_x + at), mount_y = load<V>(aims.from_y + at);
    const V along_x = load<V>(aims.along_x + at), along_y = load<V>(aims.along_y + at);
    store(x + (ahead_x * mount_x - ahead_y * mount_y), rays.from_x + at);
    store(y + (ahead_y * mount_x + ahead_x * mount_y), rays.from_y + at);
    store(ahead_x * along_x - ahead_y * along_y, rays.along_x + at);
    store(ahead_y * along_x + ahead_x * along_y, rays.along_y + at);
    store(load<V>(aims.limit_m + at), rays.range_m + at);
    store(all<V>(-1), rays.name + at);
  }
}

template <class V>
void meet_segments(const RayColumns& rays, const SegmentColumns& s) noexcept {
  each_group<V>(rays, [&](RayLanes<V>& ray) {
    for (std::size_t n = 0; n < s.count; ++n) meet_nth(ray, s, n);
  });
}
template <class V>
void meet_chosen_segments(const RayColumns& rays, const SegmentColumns& s, Chosen chosen) noexcept {
  each_group<V>(rays, [&](RayLanes<V>& ray) {
    for (std::size_t k = 0; k < chosen.count; ++k) meet_nth(ray, s, chosen.places[k]);
  });
}
template <Within within, class V>
void meet_circles_as(const RayColumns& rays, const CircleColumns& c) noexcept {
  each_group<V>(rays, [&](RayLanes<V>& ray) {
    for (std::size_t n = 0; n < c.count; ++n) meet_nth<within>(ray, c, n);
  });
}
template <Within within, class V>
void meet_chosen_circles_as(const RayColumns& rays, const CircleColumns& c, Chosen chosen) noexcept {
  each_group<V>(rays, [&](RayLanes<V>& ray) {
    for (std::size_t k = 0; k < chosen.count; ++k) meet_nth<within>(ray, c, chosen.places[k]);
  });
}
template <class V>
void meet_circles(const RayColumns& rays, const CircleColumns& c, Within within) noexcept {
  within == Within::Seen ? meet_circles_as<Within::Seen, V>(rays, c) : meet_circles_as<Within::Unseen, V>(rays, c);
}
template <class V>
void meet_chosen_circles(const RayColumns& rays, const CircleColumns& c, Within within, Chosen chosen) noexcept {
  within == Within::Seen ? meet_chosen_circles_as<Within::Seen, V>(rays, c, chosen)
                         : meet_chosen_circles_as<Within::Unseen, V>(rays, c, chosen);
}

/// The nearest of all lanes, of equal ones that with the lowest name, becomes the first ray's.
template <class V>
void keep_nearest_lane(const RayLanes<V>& ray, const RayColumns& rays) noexcept {
  double range_m[kWidth<V>], name[kWidth<V>];
  store(ray.range_m, range_m);
  double nearest_m = range_m[0];
  for (std::size_t k = 1; k < kWidth<V>; ++k) nearest_m = std::min(nearest_m, range_m[k]);
  if (!(nearest_m < rays.range_m[0])) return;
  store(ray.name, name);
  for (std::size_t k = 0; k < kWidth<V>; ++k) {
    if (range_m[k] > rays.range_m[0] || (range_m[k] == rays.range_m[0] && name[k] >= rays.name[0])) continue;
    rays.range_m[0] = range_m[k];
    rays.name[0] = name[k];
  }
}

template <class V>
void meet_segments_alone(const RayColumns& rays, const SegmentColumns& s) noexcept {
  RayLanes<V> ray = first_ray<V>(rays);
  for (std::size_t n = 0; n < s.count; n += kWidth<V>) {
    meet_segment(ray, load<V>(s.from_x + n), load<V>(s.from_y + n), load<V>(s.to_x + n), load<V>(s.to_y + n),
                 load<V>(s.name + n));
  }
  keep_nearest_lane(ray, rays);
}
template <Within within, class V>
void meet_circles_alone_as(const RayColumns& rays, const CircleColumns& c) noexcept {
  RayLanes<V> ray = first_ray<V>(rays);
  for (std::size_t n = 0; n < c.count; n += kWidth<V>) {
    meet_circle<within>(ray, load<V>(c.x + n), load<V>(c.y + n), load<V>(c.radius + n), load<V>(c.name + n));
  }
  keep_nearest_lane(ray, rays);
}
template <class V>
void meet_circles_alone(const RayColumns& rays, const CircleColumns& c, Within within) noexcept {
  within == Within::Seen ? meet_circles_alone_as<Within::Seen, V>(rays, c)
                         : meet_circles_alone_as<Within::Unseen, V>(rays, c);
}

/// The wedge in all lanes, with a direction between its edges that is not of unit length.
template <class V>
struct WedgeLanes {
  explicit WedgeLanes(const Wedge& w) noexcept
      : x(all<V>(w.x)),
        y(all<V>(w.y)),
        right_x(all<V>(w.right_x)),
        right_y(all<V>(w.right_y)),
        left_x(all<V>(w.left_x)),
        left_y(all<V>(w.left_y)),
        mid_x(right_x + left_x),
        mid_y(right_y + left_y) {}
  V x, y, right_x, right_y, left_x, left_y, mid_x, mid_y;
};

/// Where a point lies from a wedge: how far to the right of its right edge, left of its left one, behind it.
template <class V>
struct Place {
  Place(const WedgeLanes<V>& w, V point_x, V point_y) noexcept {
    const V x = point_x - w.x, y = point_y - w.y;
    right = w.right_y * x - w.right_x * y;
    left = w.left_x * y - w.left_y * x;
    behind = -(w.mid_x * x + w.mid_y * y);
  }
  V right, left, behind;
};

/// For each set of up to four lanes which they are, in rising order; what follows is of no use.
struct LaneSet {
  std::uint32_t lane[4];
  std::size_t count;
};
constexpr std::array<LaneSet, 16> lane_sets() noexcept {
  std::array<LaneSet, 16> sets{};
  for (unsigned set = 0; set < 16; ++set) {
    for (std::uint32_t lane = 0; lane < 4; ++lane) {
      if ((set >> lane & 1u) != 0) sets[set].lane[sets[set].count++] = lane;
    }
  }
  return sets;
}
constexpr std::array<LaneSet, 16> kLaneSets = lane_sets();

/// Puts down the places at + k, all below count, of the lanes that are not hidden; writes up to three places more.
template <class V, class Hidden>
[[gnu::always_inline]] inline std::size_t put_down(const Hidden& hidden, std::size_t at, std::size_t count,
                                                   std::uint32_t* chosen, std::size_t found) noexcept {
  unsigned seen = ~signs(hidden) & ((1u << std::min(kWidth<V>, count - at)) - 1);
  for (std::size_t k = 0; k < kWidth<V>; k += 4, seen >>= 4) {
    const LaneSet& set = kLaneSets[seen & 15u];
    for (std::size_t n = 0; n < 4; ++n) chosen[found + n] = static_cast<std::uint32_t>(at + k) + set.lane[n];
    found += set.count;
  }
  return found;
}

template <class V>
std::size_t choose_segments(const Wedge& wedge, const SegmentColumns& s, std::uint32_t* chosen) noexcept {
  const WedgeLanes<V> w(wedge);
  const V margin = all<V>(kWedgeMargin_m);
  std::size_t found = 0;
  for (std::size_t n = 0; n < s.count; n += kWidth<V>) {
    const Place<V> a(w, load<V>(s.from_x + n), load<V>(s.from_y + n)), b(w, load<V>(s.to_x + n), load<V>(s.to_y + n));
    const auto hidden = ((a.right > margin) & (b.right > margin)) | ((a.left > margin) & (b.left > margin)) |
                        ((a.behind > margin) & (b.behind > margin));
    found = put_down<V>(hidden, n, s.count, chosen, found);
  }
  return found;
}

template <class V>
std::size_t choose_circles(const Wedge& wedge, const CircleColumns& c, std::uint32_t* chosen) noexcept {
  const WedgeLanes<V> w(wedge);
  std::size_t found = 0;
  for (std::size_t n = 0; n < c.count; n += kWidth<V>) {
    const V reach = load<V>(c.radius + n) + kWedgeMargin_m;
    const Place<V> centre(w, load<V>(c.x + n), load<V>(c.y + n));
    const auto hidden = (centre.right > reach) | (centre.left > reach) | (centre.behind > 2 * reach);
    found = put_down<V>(hidden, n, c.count, chosen, found);
  }
  return found;
}

template <class V>
constexpr Lanes lanes_of(const char* name) noexcept {
  return {name,
          aim<V>,
          meet_segments<V>,
          meet_chosen_segments<V>,
          meet_circles<V>,
          meet_chosen_circles<V>,
          meet_segments_alone<V>,
          meet_circles_alone<V>,
          choose_segments<V>,
          choose_circles<V>};
}

}  // namespace
}  // namespace ganglion::sim
