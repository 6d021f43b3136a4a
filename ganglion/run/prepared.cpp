#include "ganglion/run/prepared.h"

#include "ganglion/application/fault/faulty_application.h"
#include "ganglion/base/text.h"
#include "ganglion/graph/order.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/run/inputs.h"
#include "ganglion/run/measure_list.h"
#include "ganglion/sim/robot/truth_channels.h"
#include "ganglion/sim/world/ground_terrain.h"

namespace ganglion {
namespace {

/// The robot a controller was drawn for; -1, and reported, where it names none that is there.
int robot_named_by(const config::Value& controller, FileReader& files, Problems& problems) {
  config::Table table(controller, "", problems);
  table.opens_by(&files);
  for (const std::string& key : table.keys()) table.known(key);
  if (!table.has("robot")) {
    table.problem("robot", ErrorCode::MissingKey,
                  {"robot is missing: name the robot.toml it is drawn for",
                   "falta robot: nombre el robot.toml para el que está dibujado"});
  }
  return table.open("robot", "robot", config::kMaxBytes);
}

/// The experiment names no robot: then it is the one the controller was drawn for.
void find_robot(FileReader& files, Experiment& experiment, Problems& problems) {
  const auto root = config::parse(files.at(experiment.opened.controller));
  if (root) experiment.opened.robot = robot_named_by(*root, files, problems);
  if (experiment.opened.robot >= 0) experiment.files.robot = files.at(experiment.opened.robot).resolved;
}

std::shared_ptr<const sim::RobotModel> load_robot(FileReader& files, const Experiment& experiment, Problems& problems) {
  if (experiment.opened.robot < 0) return nullptr;
  auto robot = sim::load_robot(files, experiment.opened.robot, sim_kinds(), experiment.robot_overrides, problems);
  if (robot != nullptr && !robot->simulated() && !experiment.link.remote()) {
    problems.add({experiment.files.robot.string(), 1, 1}, ErrorCode::MissingKey,
                 {"describes a robot without [drive]: it cannot be simulated; where is it? Give application.address",
                  "describe un robot sin [drive]: no se puede simular; ¿dónde está? Dé application.address"});
  }
  return robot;
}

std::shared_ptr<const sim::Ground> open_ground(Problems& problems) {
  auto ground = sim::Ground::make(sim::GroundPlan{.name = "open ground"}, problems);
  return ground ? std::make_shared<const sim::Ground>(std::move(*ground)) : nullptr;
}

std::shared_ptr<const sim::Ground> load_ground(FileReader& files, const Experiment& experiment, Problems& problems) {
  if (experiment.opened.world < 0) return open_ground(problems);
  auto ground = sim::Ground::load(files, experiment.opened.world, problems, experiment.world_overrides);
  return ground ? std::make_shared<const sim::Ground>(std::move(*ground)) : nullptr;
}

/// Every fault that names nothing; then what all of them together come to.
void check_faults(const Experiment& experiment, const RobotDescription& robot, double step_s, Problems& problems) {
  bool sound = true;
  for (const Fault& fault : experiment.faults) {
    if (const auto site = site_of(fault, robot); !site) problems.add(site.error()), sound = false;
  }
  if (!sound) return;
  if (const auto plans = plan_faults(experiment.faults, robot, experiment.robots, step_s); !plans)
    problems.add(plans.error());
}

/// The controller, made once on trial: nothing that it would refuse is found only when a run begins.
void try_controller(Prepared& prepared, Problems& problems) {
  const Identity identity{prepared.experiment.seed, 0, 0};
  const auto made = Controller::compile(prepared.controller, prepared.robot->description, controller_kinds(), identity);
  if (!made) {
    problems.add(made.error());
  } else {
    prepared.signals = measured_signals(*made);
  }
}

void check_figure(const std::string& name, const Criterion& criterion, bool stops, const std::vector<Figure>& figures,
                  Problems& problems) {
  std::vector<std::string> names;
  for (const Figure& figure : figures) {
    const bool fits = stops ? figure.running : figure.listed;
    if (fits && figure.name == name) return;
    if (fits) names.push_back(figure.name);
  }
  Error error{
      ErrorCode::UnknownKey,
      say({"\"{}\": this experiment has no measure \"{}\"{}", "\"{}\": este experimento no tiene la medida \"{}\"{}"},
          criterion.text(), name, suggestion(name, names)),
      criterion.place,
      {.part = stops ? "run.stop" : "success", .found = name, .choices = names}};
  problems.add(std::move(error));
}

/// Criteria speak of figures that there are.
void check_criteria(const Prepared& prepared, Problems& problems) {
  const auto check = [&](const std::vector<Criterion>& criteria, bool stops) {
    for (const Criterion& criterion : criteria) {
      check_figure(criterion.name, criterion, stops, prepared.figures, problems);
      if (!criterion.times.empty()) check_figure(criterion.times, criterion, stops, prepared.figures, problems);
    }
  };
  check(prepared.experiment.stop, true);
  check(prepared.experiment.success, false);
}

}  // namespace

MeasureScope Prepared::scope() const {
  MeasureScope scope{.signals = signals, .terrain = terrain.get()};
  if (robot == nullptr || !robot->simulated()) return scope;
  scope.truth = sim::truth_channels();
  scope.radius_m = robot->radius_m;
  if (robot->trained) scope.goals = sim::TrainerLedger::columns_of_goals();
  return scope;
}

sim::SimulationConfig Prepared::simulation(std::shared_ptr<const sim::Ground> on,
                                           const std::vector<Pose2>& starts) const {
  const SpawnChoice& choice = experiment.spawn;
  sim::SpawnRule rule = sim::SpawnRandom{choice.clearance_m, choice.yaw};
  if (!choice.id.empty()) rule = sim::SpawnNamed{choice.id};
  if (choice.pose) rule = sim::SpawnPoses{{*choice.pose}};
  if (!starts.empty()) rule = sim::SpawnPoses{starts};
  return {.ground = std::move(on), .model = robot, .robots = experiment.robots, .spawn = std::move(rule)};
}

std::optional<ControllerModel> load_controller(FileReader& files, int controller,
                                               const std::vector<config::Override>& overrides,
                                               const RobotDescription* robot, Problems& problems) {
  auto root = config::parse(files.at(controller));
  if (!root) {
    problems.add(root.error());
    return std::nullopt;
  }
  for (const config::Override& override : overrides) {
    if (auto applied = config::apply(*root, override); !applied) problems.add(applied.error());
  }
  ControllerModel model = read_controller(*root, controller_kinds(), problems, &files);
  std::optional<RobotDescription> own;
  if (robot == nullptr) {
    const int named = robot_named_by(*root, files, problems);
    if (named < 0) return std::nullopt;
    own = sim::load_description(files, named, sim_kinds(), {}, problems);
    if (!own) return std::nullopt;
    robot = &*own;
  }
  resolve(model, *robot, problems);
  order(model, problems);
  if (!problems.empty()) return std::nullopt;
  return model;
}

std::optional<Prepared> prepare(const std::filesystem::path& path, const std::vector<config::Override>& overrides,
                                Problems& problems, const ExperimentFiles& instead) {
  DiskFiles files;
  return prepare(files, path, overrides, problems, instead);
}

std::optional<Prepared> prepare(FileReader& files, const std::filesystem::path& path,
                                const std::vector<config::Override>& overrides, Problems& problems,
                                const ExperimentFiles& instead) {
  Prepared prepared;
  prepared.experiment = read_experiment(files, path, overrides, problems, instead);
  Experiment& experiment = prepared.experiment;
  const OpenedInputs& opened = experiment.opened;
  if (opened.controller < 0) return std::nullopt;
  if (opened.robot < 0) find_robot(files, experiment, problems);
  prepared.robot = load_robot(files, experiment, problems);
  const RobotDescription* description = prepared.robot != nullptr ? &prepared.robot->description : nullptr;
  auto model = load_controller(files, opened.controller, experiment.controller_overrides, description, problems);
  prepared.ground = load_ground(files, experiment, problems);
  if (experiment.free_ground) prepared.open_ground = open_ground(problems);
  if (description != nullptr) {
    prepared.step_s = model && model->tick_s > 0 ? model->tick_s : description->tick_s;
    check_faults(experiment, *description, prepared.step_s, problems);
  }
  if (!problems.empty() || !model || prepared.ground == nullptr) return std::nullopt;
  prepared.controller = std::move(*model);
  prepared.terrain = std::make_shared<const sim::GroundTerrain>(prepared.ground);
  try_controller(prepared, problems);
  prepared.figures = figures_in(prepared.scope());
  check_criteria(prepared, problems);
  if (!problems.empty()) return std::nullopt;
  prepared.controller_hash =
      controller_hash(files.at(opened.controller), prepared.controller, experiment.controller_overrides);
  prepared.files.assign(files.opened().begin(), files.opened().end());
  return prepared;
}

}  // namespace ganglion
