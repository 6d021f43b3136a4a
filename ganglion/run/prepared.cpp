#include "ganglion/run/prepared.h"

#include "ganglion/application/fault/faulty_application.h"
#include "ganglion/base/text.h"
#include "ganglion/graph/order.h"
#include "ganglion/kinds/applications.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/run/bounds.h"
#include "ganglion/run/controller_hash.h"
#include "ganglion/run/measure_list.h"

namespace ganglion {
namespace {

constexpr double kLongTick_s = 1;  // of something that drives

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

std::shared_ptr<const ApplicationModel> load_application(FileReader& files, const Experiment& experiment,
                                                         Problems& problems) {
  if (experiment.opened.robot < 0) return nullptr;
  auto root = config::parse(files.at(experiment.opened.robot));
  if (!root) {
    problems.add(root.error());
    return nullptr;
  }
  const std::size_t before = problems.size();
  for (const config::Override& override : experiment.robot_overrides) {
    if (auto applied = config::apply(*root, override); !applied) problems.add(applied.error());
  }
  config::Table setting = setting_of(experiment, problems);
  auto model = read_application({.file = *root,
                                 .files = &files,
                                 .setting = &setting,
                                 .world = experiment.opened.world,
                                 .world_overrides = experiment.world_overrides,
                                 .robots = experiment.robots,
                                 .here = !experiment.link.remote()},
                                problems);
  setting.finish();
  return problems.size() == before ? model : nullptr;
}

/// Every fault that names nothing; then what all of them together come to.
void check_faults(const Experiment& experiment, const Description& robot, double step_s, Problems& problems) {
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
  const auto made =
      Controller::compile(prepared.controller, prepared.application->description(), controller_kinds(), identity);
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
  const auto& body = application->description().body;
  return {.truth = application->truth(),
          .signals = signals,
          .ledgers = application->ledgers(),
          .terrain = application->terrain(),
          .radius_m = body ? body->radius_m : 0};
}

std::optional<ControllerModel> load_controller(FileReader& files, int controller,
                                               const std::vector<config::Override>& overrides, const Description* robot,
                                               Problems& problems) {
  auto root = config::parse(files.at(controller));
  if (!root) {
    problems.add(root.error());
    return std::nullopt;
  }
  for (const config::Override& override : overrides) {
    if (auto applied = config::apply(*root, override); !applied) problems.add(applied.error());
  }
  ControllerModel model = read_controller(*root, controller_kinds(), problems, &files);
  std::optional<Description> own;
  if (robot == nullptr) {
    const int named = robot_named_by(*root, files, problems);
    if (named < 0) return std::nullopt;
    own = read_description(files, named, {}, problems);
    if (!own) return std::nullopt;
    robot = &*own;
  }
  if (robot->body && !robot->commands.empty() && model.tick_s > kLongTick_s) {
    const config::Value* tick = root->find("tick_s");
    problems.note(tick->place(), say({"tick_s is {}: a robot drives so long on one look at its sensors",
                                      "tick_s es {}: un robot avanza ese tiempo con una sola lectura de sus sensores"},
                                     shortest(model.tick_s) + " s"));
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
  prepared.application = load_application(files, experiment, problems);
  const Description* description = prepared.application != nullptr ? &prepared.application->description() : nullptr;
  auto model = load_controller(files, opened.controller, experiment.controller_overrides, description, problems);
  if (description != nullptr) {
    prepared.step_s = model && model->tick_s > 0 ? model->tick_s : description->tick_s;
    check_faults(experiment, *description, prepared.step_s, problems);
  }
  if (!problems.empty() || !model) return std::nullopt;
  prepared.controller = std::move(*model);
  check_bounds(prepared, problems);
  if (!problems.empty()) return std::nullopt;
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
