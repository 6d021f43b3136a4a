#include "ganglion/plot/old_run_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "ganglion/plot/json_view.h"

namespace ganglion::plot {
namespace {

constexpr std::size_t kMaxOldRobots = 10000;
constexpr std::size_t kMaxWholeBytes = std::size_t{256} << 20;  // of maps as a whole, all together
constexpr std::size_t kMaxGoals = 100000;
constexpr std::size_t kShapes = 64;  // that one state holds of a growing list: the newest

/// Whether the cell that holds `point` is inhibited; not outside the map.
bool inhibited_at(const shown::Field& field, Vector2 point) noexcept {
  const double column = std::floor((point.x - field.origin.x) / field.cell.x);
  const double row = std::floor((point.y - field.origin.y) / field.cell.y);
  if (!(column >= 0 && row >= 0 && column < field.columns && row < field.rows)) return false;
  const std::size_t cell =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(field.columns) + static_cast<std::size_t>(column);
  return field.cells[3][cell] != 0 && field.cells[3][cell] != shown::kUnknownCell;
}

Role role_of_state(const std::string& state) {
  if (state == "set") return Role::Goal;
  if (state == "reached") return Role::Reached;
  return state == "replaced" ? Role::Past : Role::GivenUp;
}

/// Reads one robot's topics.
class OldRobot {
 public:
  OldRobot(const RunFile& file, int number, std::size_t& unread, std::size_t& whole_bytes)
      : file_(file), number_(number), unread_(unread), whole_bytes_(whole_bytes) {}

  std::vector<ExhibitTrack> read() {
    const std::string prefix = fmt::format("/robot{}/", number_);
    for (auto topic = file_.json.lower_bound(prefix); topic != file_.json.end() && topic->first.starts_with(prefix);
         ++topic) {
      const std::string name = topic->first.substr(prefix.size());
      if (name.starts_with("map/")) read_map(topic->second, name.substr(4));
      if (name.starts_with("route/")) read_route(topic->second, name.substr(6));
      if (name == "goals") read_goals(topic->second);
    }
    std::erase_if(tracks_, [](const ExhibitTrack& track) { return track.states.empty(); });
    return std::move(tracks_);
  }

 private:
  ExhibitTrack begin(const std::string& owner, std::string_view form, std::string_view name) const {
    return *track_of(exhibit_topic({number_, owner.empty() ? "run" : owner}, form, name));
  }

  template <class Use>
  void each(const JsonTopic& topic, Use use) {
    for (const JsonMessage& message : topic.messages) {
      const auto json = parse_object(message.text);
      if (!json || !use(*json, message.time_s)) ++unread_;
    }
  }

  void read_map(const JsonTopic& topic, const std::string& component) {
    ExhibitTrack map = begin(component, "field", "map"), attempts = begin(component, "marks", "attempts");
    std::optional<shown::Field> before;
    double before_s = 0;
    each(topic, [&](const Json& message, double time_s) {
      auto now = old_map(message);
      if (!now || (before && now->cell != before->cell)) return false;
      const bool same = before && now->same_make(*before);
      whole_bytes_ += same ? 0 : 4 * now->cells[0].size();
      if (whole_bytes_ > kMaxWholeBytes) return false;
      if (!same) {
        map.add(time_s, {{"Learned map", "Mapa aprendido"}, *now});
      } else if (auto patch = shown::difference(*before, *now)) {
        map.add(time_s, {{}, std::move(*patch)});
      }
      add_attempts(attempts, before ? &*before : nullptr, *now, before_s, time_s);
      before = std::move(now);
      before_s = time_s;
      return true;
    });
    tracks_.push_back(std::move(map));
    tracks_.push_back(std::move(attempts));
  }

  void add_attempts(ExhibitTrack& attempts, const shown::Field* before, const shown::Field& now, double after_s,
                    double until_s) {
    bool any = false;
    for (int row = 0; row < now.rows; ++row) {
      for (int column = 0; column < now.columns; ++column) {
        const Vector2 centre = now.origin + Vector2{column + 0.5, row + 0.5} * now.cell.x;
        if (!inhibited_at(now, centre) || (before != nullptr && inhibited_at(*before, centre))) continue;
        const auto from = nearest(centre, after_s, until_s);
        if (!from) continue;
        any = true;
        tried_.push_back(shown::Shape{.role = Role::Tried, .frame = "world", .points = {*from, centre}});
        if (tried_.size() > kShapes) tried_.pop_front();
      }
    }
    if (!any) return;
    attempts.add(until_s, {{"Failed attempts", "Intentos fallidos"}, shown::Marks{{tried_.begin(), tried_.end()}}});
  }

  /// Where the robot was nearest to `place` in (after_s, until_s]; none where it was nowhere known.
  std::optional<Vector2> nearest(Vector2 place, double after_s, double until_s) const {
    const ganglion::SignalTable* table = file_.table(fmt::format("/robot{}/signals", number_));
    const auto x = table != nullptr ? table->column("truth.x_m") : std::nullopt;
    const auto y = table != nullptr ? table->column("truth.y_m") : std::nullopt;
    std::optional<Vector2> result;
    if (!x || !y) return result;
    const auto first = std::upper_bound(table->times_s.begin(), table->times_s.end(), after_s);
    auto row = static_cast<std::size_t>(first - table->times_s.begin());
    double least = std::numeric_limits<double>::infinity();
    for (row = row > 0 ? row - 1 : 0; row < table->rows() && table->times_s[row] <= until_s; ++row) {
      const Vector2 at{table->at(row, *x), table->at(row, *y)};
      if (!((at - place).squared() < least)) continue;
      least = (at - place).squared();
      result = at;
    }
    return result;
  }

  void read_route(const JsonTopic& topic, const std::string& component) {
    ExhibitTrack route = begin(component, "marks", "route");
    each(topic, [&](const Json& message, double time_s) {
      shown::Marks marks;
      auto points = points_in(message, "points");
      std::erase_if(points, [](Vector2 point) { return !std::isfinite(point.x + point.y); });
      if (!points.empty()) {
        marks.shapes.push_back({.role = Role::Plan, .frame = "world", .points = std::move(points)});
      }
      return route.add(time_s, {{"Route", "Ruta"}, std::move(marks)});
    });
    tracks_.push_back(std::move(route));
  }

  void read_goals(const JsonTopic& topic) {
    ExhibitTrack track = begin("", "marks", "goals");
    std::vector<shown::Shape> goals;
    each(topic, [&](const Json& message, double time_s) {
      const double index = number_in(message, "index", -1);
      if (!(index >= 0 && index <= static_cast<double>(goals.size()) && index < double{kMaxGoals})) return false;
      const auto i = static_cast<std::size_t>(index);
      if (i == goals.size()) goals.push_back(goal_of(message, i));
      goals[i].role = role_of_state(text_in(message, "state"));
      const auto first = goals.size() > kShapes ? goals.end() - kShapes : goals.begin();
      return track.add(time_s, {{"Goals", "Objetivos"}, shown::Marks{{first, goals.end()}}});
    });
    tracks_.push_back(std::move(track));
  }

  static shown::Shape goal_of(const Json& message, std::size_t index) {
    const std::string number = fmt::format("{}", index + 1);
    return {.form = Form::Disc,
            .id = "goal " + number,
            .frame = "world",
            .points = {{number_in(message, "x_m"), number_in(message, "y_m")}},
            .label = Sentence::quoted(number)};
  }

  const RunFile& file_;
  int number_;
  std::size_t& unread_;
  std::size_t& whole_bytes_;
  std::vector<ExhibitTrack> tracks_;
  std::deque<shown::Shape> tried_;
};

}  // namespace

std::vector<ExhibitTrack> old_exhibits(const RunFile& file, std::size_t& unread) {
  std::vector<ExhibitTrack> tracks;
  std::size_t whole_bytes = 0;
  for (std::size_t i = 0; i < kMaxOldRobots; ++i) {
    const std::string prefix = fmt::format("/robot{}/", i);
    const auto topic = file.json.lower_bound(prefix);
    const bool any = topic != file.json.end() && topic->first.starts_with(prefix);
    if (!any && file.table(prefix + "signals") == nullptr) break;
    OldRobot robot(file, static_cast<int>(i), unread, whole_bytes);
    for (ExhibitTrack& track : robot.read()) tracks.push_back(std::move(track));
  }
  return tracks;
}

}  // namespace ganglion::plot
