#include "ganglion/plot/from_run_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ganglion/plot/json_view.h"
#include "ganglion/plot/old_run_file.h"
#include "ganglion/record/exhibit/exhibit_codec.h"

namespace ganglion::plot {
namespace {

constexpr std::size_t kMaxRobots = 10000;
constexpr std::size_t kMaxEvents = 20000;
constexpr std::size_t kMaxExhibits = 2000;

/// Reads one run; counts what it could not make sense of.
class Reader {
 public:
  explicit Reader(const RunFile& file) : file_(file) {}

  RunView read() {
    view_.name = file_.info.name;
    view_.seed = file_.info.seed;
    if (file_.outcome) read_outcome(*file_.outcome);
    const std::optional<Json> described = first("/run");
    const std::optional<Json> scene = first("/scene");
    if (scene) view_.scene = scene_from(*scene);
    each("/movers", [&](const Json& message, double time_s) { read_movers(message, time_s); });
    each("/log", [&](const Json& message, double time_s) { read_log(message, time_s); });
    for (std::size_t i = 0; i < kMaxRobots; ++i)
      if (!read_robot(i, described.value_or(Json()))) break;
    view_.exhibits = exhibits_of(file_, unread_);
    for (const Sentence& damage : file_.damages) view_.events.push_back({view_.duration_s, Severity::Error, damage});
    if (unread_ > 0)
      view_.events.push_back({view_.duration_s, Severity::Warning,
                              say({"{} messages of the run file could not be read",
                                   "no se pudieron leer {} mensajes del archivo de la ejecución"},
                                  unread_)});
    return std::move(view_);
  }

 private:
  template <class Use>
  void each(std::string_view topic, Use use) {
    const auto found = file_.json.find(topic);
    if (found == file_.json.end()) return;
    for (const JsonMessage& message : found->second.messages) {
      if (const auto json = parse_object(message.text))
        use(*json, message.time_s);
      else
        ++unread_;
    }
  }
  std::optional<Json> first(std::string_view topic) {
    const auto found = file_.json.find(topic);
    if (found == file_.json.end() || found->second.messages.empty()) return std::nullopt;
    auto json = parse_object(found->second.messages.front().text);
    if (!json) ++unread_;
    return json;
  }

  void read_outcome(const ganglion::RunOutcome& outcome) {
    view_.outcome = RunOutcome{outcome.verdict, outcome.reason, Sentence::quoted(outcome.criterion), outcome.digest};
    for (const auto& [name, value] : outcome.measures) view_.measures.push_back({name, value});
  }

  void read_movers(const Json& message, double time_s) {
    const auto list = message.find("movers");
    if (list == message.end() || !list->is_array()) return;
    for (const Json& place : *list) {
      const std::string id = text_in(place, "id");
      const auto mover = std::ranges::find(view_.scene.movers, id, &Mover::id);
      if (mover == view_.scene.movers.end()) continue;
      const Pose2 pose{{number_in(place, "x_m"), number_in(place, "y_m")},
                       Angle::from_rad(number_in(place, "yaw_rad"))};
      if (pose == mover->poses.back()) continue;
      mover->times_s.push_back(time_s);
      mover->poses.push_back(pose);
    }
  }

  void read_log(const Json& message, double time_s) {
    constexpr double kWarning = 3, kError = 4;  // foxglove.Log
    if (view_.events.size() >= kMaxEvents) return;
    const double level = number_in(message, "level");
    Sentence text{text_in(message, "message"), text_in(message, "message_es")};
    if (const std::string name = text_in(message, "name"); !name.empty()) {
      text.en = name + ": " + text.en;
      if (!text.es.empty()) text.es = name + ": " + text.es;
    }
    view_.events.push_back({time_s,
                            level >= kError     ? Severity::Error
                            : level >= kWarning ? Severity::Warning
                                                : Severity::Info,
                            std::move(text)});
  }

  /// False where the file has no robot of that number.
  bool read_robot(std::size_t number, const Json& described) {
    const auto robots = described.is_object() ? described.find("robots") : described.end();
    const bool known = robots != described.end() && robots->is_array() && number < robots->size();
    const ganglion::SignalTable* table = file_.table(fmt::format("/robot{}/signals", number));
    if (!known && table == nullptr) return false;
    RobotView robot;
    robot.name = fmt::format("robot{}", number);
    if (known) describe(robot, (*robots)[number]);
    if (table != nullptr) read_signals(robot, *table);
    const auto coordinators = described.is_object() ? described.find("coordinators") : described.end();
    if (coordinators != described.end() && coordinators->is_array())
      for (const Json& coordinator : *coordinators)
        if (auto decided = coordination_from(coordinator, robot.signals))
          robot.coordinations.push_back(std::move(*decided));
    view_.robots.push_back(std::move(robot));
    return true;
  }

  void describe(RobotView& robot, const Json& json) {
    if (const std::string name = text_in(json, "name"); !name.empty()) robot.name += " " + name;
    robot.length_m = number_in(json, "length_m");
    robot.width_m = number_in(json, "width_m");
    robot.radius_m = number_in(json, "radius_m");
    if (!json.is_object() || !json.contains("sensors") || !json.at("sensors").is_array()) return;
    for (const Json& sensor : json.at("sensors")) {
      const double max_range_m = number_in(sensor, "max_range_m");
      if (!(max_range_m > 0)) continue;  // no range sensor
      const Pose2 mount{{number_in(sensor, "x_m"), number_in(sensor, "y_m")},
                        Angle::from_rad(number_in(sensor, "yaw_rad"))};
      robot.sensors.push_back({text_in(sensor, "id"), text_in(sensor, "kind"), mount, number_in(sensor, "cone_rad"),
                               max_range_m, text_in(sensor, "signal")});
    }
  }

  void read_signals(RobotView& robot, const ganglion::SignalTable& table) {
    for (const SignalColumn& column : table.columns) robot.signals.columns.push_back({column.name, column.unit});
    robot.signals.times_s = table.times_s;
    robot.signals.values = table.values;
    if (!table.times_s.empty()) view_.duration_s = std::max(view_.duration_s, table.times_s.back() + file_.info.tick_s);
    const auto column = [&](const char* name) {
      std::vector<double> values(table.rows(), std::numeric_limits<double>::quiet_NaN());
      if (const auto found = table.column(name))
        for (std::size_t row = 0; row < table.rows(); ++row) values[row] = table.at(row, *found);
      return values;
    };
    robot.track.times_s = table.times_s;
    robot.track.x_m = column("truth.x_m");
    robot.track.y_m = column("truth.y_m");
    robot.track.yaw_rad = column("truth.yaw_rad");
    for (const double touching : column("truth.touching")) robot.track.touching.push_back(touching > 0);
  }

  const RunFile& file_;
  RunView view_;
  std::size_t unread_ = 0;
};

}  // namespace

std::vector<ExhibitTrack> exhibits_of(const RunFile& file, std::size_t& unread) {
  if (file.exhibits.empty()) return old_exhibits(file, unread);
  std::vector<ExhibitTrack> tracks;
  for (const auto& [topic, messages] : file.exhibits) {
    auto track = track_of(topic);
    if (!track || tracks.size() >= kMaxExhibits) {
      unread += messages.size();
      continue;
    }
    for (const ExhibitMessage& message : messages) {
      auto state = decode_exhibit(message.bytes);
      if (!state || !track->add(message.time_s, std::move(*state))) ++unread;
    }
    if (!track->states.empty()) tracks.push_back(std::move(*track));
  }
  return tracks;
}

RunView from_run_file(const RunFile& file) { return Reader(file).read(); }

}  // namespace ganglion::plot
