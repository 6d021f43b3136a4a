#include "ganglion/run/run_writer.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "ganglion/base/hash.h"
#include "ganglion/base/text.h"
#include "ganglion/link/wire/words.h"
#include "ganglion/run/exhibit_writer.h"
#include "ganglion/sim/world/scene.h"

namespace ganglion {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kInfo = 2, kWarning = 3;  // levels of foxglove.Log

/// What is recorded of a link; never part of a digest.
const std::array<SignalColumn, 6> kLinkColumns = {{{"link.round_trip_s", "s"},
                                                   {"link.clock_offset_s", "s"},
                                                   {"link.reconnections", ""},
                                                   {"link.repeated", ""},
                                                   {"link.lost", ""},
                                                   {"link.late", ""}}};

std::vector<SignalColumn> columns_of(const Controller& controller, std::span<const TruthChannel> truth) {
  std::vector<SignalColumn> columns;
  for (const TruthChannel& channel : truth) columns.push_back({"truth." + channel.name, channel.unit});
  for (const Signal& signal : controller.signals()) columns.push_back({signal.name, signal.unit});
  return columns;
}

/// A signal that shows a sensor's range: the sensation that is bound to one of its channels.
std::string signal_of(const std::string& sensor, const ControllerModel& model) {
  for (const ComponentModel& component : model.components) {
    if (component.component_class == ComponentClass::Sensation && component.channel == sensor + ".range") {
      return component.id;
    }
  }
  return "";
}

Json sensor_json(const sim::SensorModel& sensor, const sim::RobotModel& robot, const ControllerModel& model) {
  Json json = {{"id", sensor.id},
               {"kind", sensor.kind->descriptor.name},
               {"x_m", sensor.mount.position.x},
               {"y_m", sensor.mount.position.y},
               {"yaw_rad", sensor.mount.yaw.rad()},
               {"cone_rad", 0},
               {"max_range_m", 0},
               {"signal", signal_of(sensor.id, model)}};
  if (sensor.kind->descriptor.parameter("cell_m") != nullptr) json["cell_m"] = sensor.parameters.real("cell_m");
  if (sensor.kind->descriptor.parameter("cone_deg") != nullptr) {
    json["cone_rad"] = Angle::from_deg(sensor.parameters.real("cone_deg")).rad();
  }
  if (const SensationChannel* range = robot.description.sensation(sensor.id + ".range"))
    json["max_range_m"] = range->max;
  return json;
}

Json coordinators_json(const ControllerModel& model) {
  Json list = Json::array();
  for (const ComponentModel& component : model.components) {
    if (component.component_class != ComponentClass::Coordinator) continue;
    Json candidates = Json::array();
    for (const Wire& wire : component.wires) {
      for (const Source& source : wire.sources) {
        if (source.kind == Source::Kind::ModuleCommand) candidates.push_back(source.text);
      }
    }
    list.push_back({{"id", component.id}, {"candidates", candidates}});
  }
  return list;
}

/// The size of a map's cells, where a component keeps one.
double cell_of(const ControllerModel& model) {
  for (const ComponentModel& component : model.components) {
    if (component.descriptor != nullptr && component.component_class == ComponentClass::Acting &&
        component.descriptor->parameter("cell_m") != nullptr) {
      return component.parameters.real("cell_m");
    }
  }
  return 0;
}

/// As the log says it; English has its name_of().
Text words_of(ReasonCode code) noexcept {
  switch (code) {
    case ReasonCode::None:
      return {"none", "ninguna"};
    case ReasonCode::Unreachable:
      return {"unreachable", "inalcanzable"};
    case ReasonCode::Trapped:
      return {"trapped", "atrapado"};
    case ReasonCode::OutsideMap:
      return {"outside_map", "fuera del mapa"};
    case ReasonCode::BadRequest:
      return {"bad_request", "solicitud imposible"};
    case ReasonCode::NoReading:
      return {"no_reading", "sin lectura"};
    case ReasonCode::AttemptsExhausted:
      return {"attempts_exhausted", "intentos agotados"};
    case ReasonCode::Preempted:
      return {"preempted", "reemplazada"};
  }
  return Text::same(name_of(code));
}

/// The same of a goal; of one that is open that it was set.
Text words_of(sim::GoalOutcome outcome) noexcept {
  switch (outcome) {
    case sim::GoalOutcome::Open:
      return {"set", "fijado"};
    case sim::GoalOutcome::Reached:
      return {"reached", "alcanzado"};
    case sim::GoalOutcome::Withdrawn:
      return {"withdrawn", "retirado"};
    case sim::GoalOutcome::TimedOut:
      return {"timed_out", "fuera de tiempo"};
    case sim::GoalOutcome::Replaced:
      return {"replaced", "reemplazado"};
  }
  return Text::same(name_of(outcome));
}

std::optional<double> goal_cell_of(const sim::RobotModel& robot) {
  for (const sim::SensorModel& sensor : robot.sensors) {
    if (sensor.kind->descriptor.parameter("cell_m") != nullptr && sensor.kind->descriptor.name == "Trainer") {
      return sensor.parameters.real("cell_m");
    }
  }
  return std::nullopt;
}

}  // namespace

RunWriter::RunWriter(RunSink& recorder, const Experiment& experiment, const ControllerModel& model,
                     std::span<const TruthChannel> truth, const RunRobots& robots,
                     const std::vector<std::unique_ptr<Controller>>& controllers)
    : recorder_(recorder),
      witness_(robots.witness()),
      truth_(truth),
      remote_(robots.remote()),
      controllers_(controllers),
      maps_every_s_(experiment.maps_every_s),
      cell_m_(cell_of(model)) {
  for (std::size_t i = 0; i < controllers.size(); ++i) {
    Robot one;
    const auto columns = columns_of(*controllers[i], truth_);
    one.table = recorder.add_table(fmt::format("/robot{}/signals", i), columns);
    one.row.resize(columns.size());
    one.statuses.assign(static_cast<std::size_t>(controllers[i]->components()), 0);
    robots_.push_back(std::move(one));
  }
  if (remote_ == nullptr) return;
  link_table_ = recorder.add_table("/link/signals", kLinkColumns);
  for (const link::Difference& one : remote_->differences()) {
    log(0, kWarning, "link", link::text_of(one));
  }
}

void RunWriter::write_scene(const sim::World& world, const sim::RobotModel& robot, const ControllerModel& model) {
  recorder_.write_json("/scene", "ganglion.Scene", 0, sim::scene_json(world));
  Json sensors = Json::array();
  for (const sim::SensorModel& sensor : robot.sensors) sensors.push_back(sensor_json(sensor, robot, model));
  Json robots = Json::array();
  for (std::size_t i = 0; i < controllers_.size(); ++i) {
    robots.push_back({{"name", robot.description.name},
                      {"length_m", robot.description.length_m},
                      {"width_m", robot.description.width_m},
                      {"radius_m", robot.radius_m},
                      {"sensors", sensors}});
  }
  goal_cell_m_ = goal_cell_of(robot).value_or(cell_m_);
  const Json run = {{"robots", robots}, {"coordinators", coordinators_json(model)}, {"cell_m", cell_m_}};
  recorder_.write_json("/run", "ganglion.Run", 0, run.dump());
}

void RunWriter::write(std::uint32_t tick, double time_s) {
  write_movers(time_s);
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Robot& robot = robots_[i];
    write_truth(i);
    const auto values = controllers_[i]->values();
    std::copy(values.begin(), values.end(), robot.row.begin() + static_cast<std::ptrdiff_t>(truth_.size()));
    recorder_.write_row(robot.table, tick, time_s, robot.row);
    write_requests(static_cast<int>(i), time_s);
    write_goals(static_cast<int>(i), time_s);
  }
  if (remote_ != nullptr) write_link(tick, time_s);
  if (time_s + 1e-9 < next_maps_s_) return;
  next_maps_s_ = time_s + maps_every_s_;
  for (std::size_t i = 0; i < robots_.size(); ++i) write_exhibits(static_cast<int>(i), time_s);
}

void RunWriter::write_intervention(const TimedIntervention& one, double time_s) {
  recorder_.write_json(kInterventionTopic, kInterventionSchema, time_s, intervention_json(one));
  log(time_s, kInfo, "intervention", intervention_text(one));
  write_movers(time_s);
  for (std::size_t i = 0; i < robots_.size(); ++i) write_goals(static_cast<int>(i), time_s);
}

void RunWriter::write_truth(std::size_t robot) {
  std::vector<double>& row = robots_[robot].row;
  if (witness_ == nullptr) {
    std::fill_n(row.begin(), truth_.size(), std::numeric_limits<double>::quiet_NaN());
    return;
  }
  std::ranges::copy(witness_->truth_of(static_cast<int>(robot)), row.begin());
}

void RunWriter::write_link(std::uint32_t tick, double time_s) {
  const link::LinkStatistics& now = remote_->statistics();
  const std::array<double, kLinkColumns.size()> row = {now.round_trip_s,
                                                       now.clock_offset_s,
                                                       static_cast<double>(now.reconnections),
                                                       static_cast<double>(now.repeated),
                                                       static_cast<double>(now.lost),
                                                       static_cast<double>(now.late)};
  recorder_.write_row(link_table_, tick, time_s, row);
  for (const link::wire::Event& event : remote_->take_events()) {
    const int level = kInfo + std::clamp(static_cast<int>(event.level()), 0, 2);
    log(time_s, level, "robot", link::read_words(event));
  }
}

void RunWriter::write_movers(double time_s) {
  const auto now = witness_ != nullptr ? witness_->movers() : std::span<const sim::MoverState>{};
  std::uint64_t hash = 1;
  for (const sim::MoverState& mover : now) {
    hash = combine(hash, canonical_bits(mover.pose.position.x));
    hash = combine(hash, canonical_bits(mover.pose.position.y) ^ canonical_bits(mover.pose.yaw.rad()));
  }
  if (hash == movers_shown_ || now.empty()) return;
  movers_shown_ = hash;
  Json movers = Json::array();
  for (const sim::MoverState& mover : now) {
    movers.push_back({{"id", mover.id},
                      {"x_m", mover.pose.position.x},
                      {"y_m", mover.pose.position.y},
                      {"yaw_rad", mover.pose.yaw.rad()}});
  }
  recorder_.write_json("/movers", "ganglion.Movers", time_s, Json{{"movers", movers}}.dump());
}

void RunWriter::log(double time_s, int level, const std::string& name, const Sentence& message) {
  const auto seconds = static_cast<long>(time_s);
  const Json json = {
      {"timestamp", {{"sec", seconds}, {"nsec", static_cast<long>((time_s - static_cast<double>(seconds)) * 1e9)}}},
      {"level", level},
      {"message", message.en},
      {"message_es", message.es},
      {"name", name}};
  recorder_.write_json("/log", "foxglove.Log", time_s, json.dump());
}

void RunWriter::write_requests(int robot, double time_s) {
  const Controller& controller = *controllers_[static_cast<std::size_t>(robot)];
  for (int i = 0; i < controller.components(); ++i) {
    const RequestSlot* request = controller.request(i);
    if (request == nullptr) continue;
    std::uint8_t& before = robots_[static_cast<std::size_t>(robot)].statuses[static_cast<std::size_t>(i)];
    const auto now = static_cast<std::uint8_t>(request->status);
    if (now != before && request->status == RequestStatus::Withdrawn) {
      log(time_s, kWarning, controller.id(i),
          say({"withdrawn: {} ({:g}, {:g})", "retirada: {} ({:g}, {:g})"}, words_of(request->reason.code),
              request->reason.first, request->reason.second));
    }
    before = now;
  }
}

void RunWriter::write_goals(int robot, double time_s) {
  const sim::TrainerLog* trainer = witness_ != nullptr ? witness_->trainer_log(robot) : nullptr;
  if (trainer == nullptr) return;
  Robot& one = robots_[static_cast<std::size_t>(robot)];
  const auto goals = trainer->records();
  std::vector<sim::GoalOutcome>& written = one.outcomes;
  for (std::size_t g = written.empty() ? 0 : written.size() - 1; g < goals.size(); ++g) {
    if (g == written.size()) {
      written.push_back(goals[g].outcome);
    } else if (written[g] != goals[g].outcome) {
      written[g] = goals[g].outcome;
    } else {
      continue;
    }
    const std::string_view state = goals[g].outcome == sim::GoalOutcome::Open ? "set" : name_of(goals[g].outcome);
    const Json json = {{"index", g},
                       {"x_m", (goals[g].goal.column + 0.5) * goal_cell_m_},
                       {"y_m", (goals[g].goal.row + 0.5) * goal_cell_m_},
                       {"state", state},
                       {"reason", name_of(goals[g].reason)}};
    recorder_.write_json(fmt::format("/robot{}/goals", robot), "ganglion.Goal", time_s, json.dump());
    log(time_s, kInfo, "trainer",
        say({"goal {} at cell {}, {}: {}", "objetivo {} en la celda {}, {}: {}"}, g + 1, goals[g].goal.column,
            goals[g].goal.row, words_of(goals[g].outcome)));
  }
}

void RunWriter::write_exhibits(int robot, double time_s) {
  const Controller& controller = *controllers_[static_cast<std::size_t>(robot)];
  for (int i = 0; i < controller.components(); ++i) {
    const Component* component = controller.component(i);
    if (component == nullptr) continue;
    ExhibitWriter writer(recorder_, robots_[static_cast<std::size_t>(robot)].shown, fmt::format("robot{}", robot),
                         controller.id(i), time_s);
    component->show(writer);
  }
}

}  // namespace ganglion
