#include "ganglion/plot/view/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

namespace ganglion::plot {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kForEver = std::numeric_limits<double>::infinity();
constexpr int kDeepest = 32;  // frames within frames

/// The frame of that name which counts for the owner: his own, else one of his robot, else of the application.
const ExhibitTrack* frame_track(const RunView& run, const ExhibitOwner& owner, std::string_view name) {
  const ExhibitTrack* best = nullptr;
  int best_rank = 0;
  for (const ExhibitTrack& track : run.exhibits) {
    if (track.form != "frame" || track.name != name) continue;
    const int rank = track.owner == owner ? 3 : track.owner.robot == owner.robot ? 2 : track.owner.robot < 0 ? 1 : 0;
    if (rank > best_rank) best = &track, best_rank = rank;
  }
  return best;
}

/// 0 where no column leads, NaN where one has no reading.
double led(const RunView& run, int robot, const std::string& column, double time_s) {
  return column.empty() ? 0 : column_at(run, robot, column, time_s);
}

std::optional<PlacedShape> placed(const RunView& run, const ExhibitOwner& owner, const shown::Shape& shape,
                                  double time_s) {
  const auto frame = frame_at(run, owner, shape.frame, time_s);
  if (!frame) return std::nullopt;
  PlacedShape result{&shape, *frame, shape.radius_m};
  if (!shape.radius.empty()) {
    const double radius_m = column_at(run, std::max(0, owner.robot), shape.radius, time_s);
    result.radius_m = std::isfinite(radius_m) && radius_m > 0 ? radius_m : 0;
  }
  return result;
}

/// What makes a shape the same one later: by its id, else by where and what it is.
bool same_thing(const shown::Shape& one, const shown::Shape& other) {
  if (one.form != other.form || one.frame != other.frame || one.id != other.id) return false;
  return !one.id.empty() || one.points == other.points;
}

/// The lasting shapes of one track, each as it was last, in the order in which they came.
std::vector<const shown::Shape*> lasting(const ExhibitTrack& track) {
  std::vector<const shown::Shape*> result;
  std::multimap<std::string, std::size_t> by_key;
  for (std::size_t state = 0; state < track.states.size(); ++state) {
    const auto* marks = std::get_if<shown::Marks>(&track.states[state].form);
    if (marks == nullptr) continue;
    const bool last = state + 1 == track.states.size();
    for (const shown::Shape& shape : marks->shapes) {
      if (!last && !look_of(shape.role).lasts) continue;
      const std::string key =
          shape.id.empty() ? fmt::format("{} {}", shape.points.front().x, shape.points.front().y) : shape.id;
      const auto [first, end] = by_key.equal_range(key);
      const auto known =
          std::find_if(first, end, [&](const auto& entry) { return same_thing(*result[entry.second], shape); });
      if (known != end) {
        result[known->second] = &shape;
      } else {
        by_key.emplace(key, result.size());
        result.push_back(&shape);
      }
    }
  }
  return result;
}

}  // namespace

double column_at(const RunView& run, int robot, std::string_view column, double time_s) {
  constexpr std::string_view kRobot = "robot";
  const std::size_t slash = column.find('/');
  if (column.starts_with(kRobot) && slash != std::string_view::npos) {
    std::from_chars(column.data() + kRobot.size(), column.data() + slash, robot);
    column.remove_prefix(slash + 1);
  }
  if (robot < 0 || static_cast<std::size_t>(robot) >= run.robots.size()) return kNone;
  const SignalTable& signals = run.robots[static_cast<std::size_t>(robot)].signals;
  const auto index = signals.find(std::string(column));
  const auto row = index_at(signals.times_s, time_s);
  return index && row ? signals.at(*row, *index) : kNone;
}

std::optional<Pose2> frame_at(const RunView& run, const ExhibitOwner& owner, std::string_view frame, double time_s) {
  Pose2 pose{};
  std::string name(frame);
  for (int depth = 0; name != "world"; ++depth) {
    const ExhibitTrack* track = depth < kDeepest && !name.empty() ? frame_track(run, owner, name) : nullptr;
    const auto* now = track != nullptr ? track->at<shown::Frame>(time_s) : nullptr;
    if (now == nullptr) return std::nullopt;
    const int robot = std::max(0, track->owner.robot);
    const Pose2 moved{{led(run, robot, now->x_m, time_s), led(run, robot, now->y_m, time_s)},
                      Angle::from_rad(led(run, robot, now->yaw_rad, time_s))};
    if (!std::isfinite(moved.position.x + moved.position.y + moved.yaw.rad())) return std::nullopt;
    pose = now->fixed.then(moved).then(pose);
    name = now->in;
  }
  return pose;
}

std::vector<PlacedShape> shapes_at(const RunView& run, double time_s) {
  std::vector<PlacedShape> result;
  for (const ExhibitTrack& track : run.exhibits) {
    const auto* marks = track.at<shown::Marks>(time_s);
    if (marks == nullptr) continue;
    for (const shown::Shape& shape : marks->shapes) {
      if (const auto one = placed(run, track.owner, shape, time_s)) result.push_back(*one);
    }
  }
  return result;
}

std::vector<PlacedShape> lasting_shapes(const RunView& run) {
  std::vector<PlacedShape> result;
  for (const ExhibitTrack& track : run.exhibits) {
    for (const shown::Shape* shape : lasting(track)) {
      if (const auto one = placed(run, track.owner, *shape, kForEver)) result.push_back(*one);
    }
  }
  return result;
}

}  // namespace ganglion::plot
