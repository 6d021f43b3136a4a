#include "ganglion/sim/simulation/crowd.h"

#include <algorithm>
#include <cmath>

namespace ganglion::sim {
namespace {

constexpr std::size_t kMeetingsPerRobot = 16;  // on the average; what is over is only blocked
constexpr double kTouch_m = 1e-6;              // discs this close to each other touch
constexpr int kLooks = 4;                      // at what the ways found so far run into
constexpr int kSweeps = 200;                   // over all meetings
constexpr double kSettled_m = 1e-8;            // of the pushes; a rounding of ways, carry() lets nothing overlap
constexpr double kExact_m = 1e-10;             // shorter ways are none
constexpr int kRounds = 6;                     // in which those behind follow those ahead
constexpr double kSameNormal = 1 - 1e-6;       // cosine

}  // namespace

void Crowd::make_room(std::size_t robots) {
  way_.resize(robots);
  room_m_.resize(robots);
  first_wall_.resize(robots);
  busy_.resize(robots);
  member_.resize(robots);
  engaged_.resize(robots);
  pressed_.resize(robots);
  members_.reserve(robots);
  near_.reserve(robots);
  meetings_.reserve(kMeetingsPerRobot * robots);
  presses_.reserve((2 * kMeetingsPerRobot + 1) * robots);
}

void Crowd::gather(Neighbours& all, std::span<const std::size_t> busy, std::span<const Wish> wishes) noexcept {
  for (const std::uint32_t member : members_) member_[member] = engaged_[member] = 0;
  for (const Press& press : presses_) pressed_[press.robot] = 0;
  members_.clear();
  meetings_.clear();
  presses_.clear();
  std::fill(busy_.begin(), busy_.end(), 0);
  double longest_m = 0;
  for (const std::size_t robot : busy) {
    busy_[robot] = 1;
    way_[robot] = wishes[robot].way;
    room_m_[robot] = wishes[robot].room_m;
    longest_m = std::max(longest_m, way_[robot].length());
  }
  const double reach_m = 2 * (radius_m_ + longest_m) + kTouch_m;
  for (const std::size_t robot : busy) {
    const auto near = all.within(all.discs()[robot].position, reach_m, robot);
    if (near.empty()) continue;
    member_[robot] = 1;
    first_wall_[robot] = 0;
    members_.push_back(static_cast<std::uint32_t>(robot));
    for (const std::uint32_t other : near) {
      if (busy_[other] != 0 && other < robot) continue;  // that one has seen this one
      if (meetings_.size() == meetings_.capacity()) break;
      meetings_.push_back(
          {.robot = static_cast<std::uint32_t>(robot), .other = other, .other_stands = busy_[other] == 0});
    }
  }
}

Vector2 Crowd::way_between(const Meeting& meeting) const noexcept {
  return meeting.other_stands ? way_[meeting.robot] : way_[meeting.robot] - way_[meeting.other];
}

/// Which pairs meet on the ways found so far. True if any does that did not before.
bool Crowd::activate(const Neighbours& all) noexcept {
  bool news = false;
  for (Meeting& meeting : meetings_) {
    if (meeting.active || meeting.wall) continue;
    const Vector2 apart = all.discs()[meeting.robot].position - all.discs()[meeting.other].position;
    const Vector2 way = way_between(meeting);
    Contact first;
    sweep_disc(apart, way, radius_m_, {{0, 0}, radius_m_}, first);
    if (!first.happened()) continue;
    meeting.active = news = true;
    engaged_[meeting.robot] = 1;
    if (!meeting.other_stands) engaged_[meeting.other] = 1;
    meeting.normal = first.normal;
    meeting.gap_m = std::max(apart.dot(first.normal) - 2 * radius_m_, 0.0);
    meeting.closing_m = std::max(-way.dot(first.normal), 0.0);
  }
  return news;
}

/// The walls and movers that the ways found so far run into. True if there is any that was not known.
bool Crowd::find_walls(const World& world, const Neighbours& all) noexcept {
  bool news = false;
  const bool only_ground = world.movers().empty();
  for (const std::uint32_t robot : members_) {
    if (only_ground && room_m_[robot] > way_[robot].length() + kTouch_m) continue;
    if (engaged_[robot] == 0 || !(way_[robot].squared() > 0) || meetings_.size() == meetings_.capacity()) continue;
    const Vector2 from = all.discs()[robot].position;
    const World::Slide slide = world.slide(from, way_[robot], radius_m_);
    if (!slide.touched || knows_wall(robot, slide.normal)) continue;
    meetings_.push_back({.robot = robot,
                         .wall = true,
                         .active = true,
                         .normal = slide.normal,
                         .gap_m = std::max(-slide.normal.dot(slide.position - from), 0.0),
                         .closing_m = std::max(-slide.normal.dot(way_[robot]), 0.0),
                         .next_wall = first_wall_[robot]});
    first_wall_[robot] = static_cast<std::uint32_t>(meetings_.size());
    news = true;
  }
  return news;
}

bool Crowd::knows_wall(std::size_t robot, Vector2 normal) const noexcept {
  for (std::uint32_t n = first_wall_[robot]; n != 0; n = meetings_[n - 1].next_wall) {
    if (meetings_[n - 1].normal.dot(normal) > kSameNormal) return true;
  }
  return false;
}

/// Shares what one meeting lacks evenly between the two; by how much that changed its push.
double Crowd::mend(Meeting& meeting) noexcept {
  const double lacks_m = -(meeting.normal.dot(way_between(meeting)) + meeting.gap_m);
  const double push_m = std::max(0.0, meeting.push_m + lacks_m * (meeting.other_stands ? 1 : 0.5));
  const double change_m = push_m - meeting.push_m;
  meeting.push_m = push_m;
  way_[meeting.robot] += meeting.normal * change_m;
  if (!meeting.other_stands) way_[meeting.other] = way_[meeting.other] - meeting.normal * change_m;
  return std::fabs(change_m);
}

/// Projected Gauss-Seidel: sweeps over the meetings until none changes any more.
void Crowd::solve() noexcept {
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    double most_m = 0;
    for (Meeting& meeting : meetings_) {
      if (meeting.active) most_m = std::max(most_m, mend(meeting));
    }
    if (most_m < kSettled_m) return;
  }
}

void Crowd::push(const World& world, Neighbours& all) noexcept {
  bool news = activate(all);
  news = find_walls(world, all) || news;
  for (int look = 0; look < kLooks && news && yields_; ++look) {
    solve();
    news = activate(all);
    news = find_walls(world, all) || news;
  }
  list_presses();
  carry(world, all);
}

void Crowd::list_presses() noexcept {
  for (const Meeting& meeting : meetings_) {
    if (!meeting.active || (yields_ && !(meeting.push_m > 0))) continue;
    presses_.push_back({meeting.robot, meeting.wall, meeting.normal, meeting.closing_m});
    pressed_[meeting.robot] = 1;
    if (meeting.wall) continue;
    presses_.push_back({meeting.other, false, -meeting.normal, meeting.closing_m});
    pressed_[meeting.other] = 1;
  }
}

/// The ways are right up to curvature and rounding; this goes them without ever overlapping anything.
void Crowd::carry(const World& world, Neighbours& all) noexcept {
  bool moved = true;
  for (int round = 0; round < kRounds && moved; ++round) {
    moved = false;
    for (std::size_t n = 0; n < members_.size(); ++n) {
      const std::size_t at = round % 2 == 0 ? n : members_.size() - 1 - n;
      moved = carry(members_[at], world, all) || moved;
    }
  }
}

bool Crowd::carry(std::size_t robot, const World& world, Neighbours& all) noexcept {
  if (!(way_[robot].squared() > kExact_m * kExact_m)) return false;
  const Vector2 from = all.discs()[robot].position;
  const World::Slide slid = slide(robot, world, all);
  bool arrived = false;
  if (engaged_[robot] == 0) {  // it meets a wall at most; robots in its way are about to leave it
    arrived = !slid.touched || near_.empty();
    if (slid.touched) press_wall(robot, near_.empty() ? slid : world.slide(from, way_[robot], radius_m_));
    engaged_[robot] = 1;
  }
  const Vector2 gone = slid.position - from;
  way_[robot] = arrived ? Vector2{} : way_[robot] - gone;
  all.put(robot, {slid.position, radius_m_});
  return gone.squared() > kExact_m * kExact_m;
}

void Crowd::press_wall(std::size_t robot, const World::Slide& slide) noexcept {
  if (!slide.touched) return;
  const double closing_m = std::max(-slide.normal.dot(way_[robot]), 0.0);
  presses_.push_back({static_cast<std::uint32_t>(robot), true, slide.normal, closing_m});
  pressed_[robot] = 1;
}

/// As far as it gets with the others where they are now.
World::Slide Crowd::slide(std::size_t robot, const World& world, Neighbours& all) noexcept {
  const Vector2 from = all.discs()[robot].position;
  near_.clear();
  for (const std::uint32_t other : all.within(from, way_[robot].length() + 2 * radius_m_ + kTouch_m, robot))
    near_.push_back(all.discs()[other]);
  return world.slide(from, way_[robot], radius_m_, near_);
}

}  // namespace ganglion::sim
