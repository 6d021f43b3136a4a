#include "ganglion/sim/robot/robot_model.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "ganglion/base/text.h"
#include "ganglion/module/find_kind.h"
#include "ganglion/sim/robot/robot_reader.h"

namespace ganglion::sim {
namespace {

using config::Range;
using config::Table;

constexpr Range kSize{1e-3, 100};
constexpr double kShortestPeriod_s = 1e-6;
constexpr double kLongTick_s = 1;  // of something that drives

void read_body(Table& root, RobotModel& model) {
  if (!root.has("body")) {
    root.problem(
        "body", ErrorCode::MissingKey,
        {"[body] is missing: length_m and width_m of the robot", "falta [body]: length_m y width_m del robot"});
    return;
  }
  const std::size_t before = root.problems().size();
  Table body = root.table("body");
  Body size{.length_m = body.number("length_m", kSize), .width_m = body.number("width_m", kSize)};
  const double half_diagonal_m = std::sqrt(size.length_m * size.length_m + size.width_m * size.width_m) / 2;
  model.climb_rad = Angle::from_deg(body.number("climb_deg", 90, Range{0, 90})).rad();
  model.tip_rad = Angle::from_deg(body.number("tip_deg", 90, Range{0, 90})).rad();
  const double radius_m = body.number("radius_m", half_diagonal_m, kSize);
  if (root.problems().size() == before) model.radius_m = size.radius_m = radius_m;  // else mounts cannot be judged
  model.description.body = std::move(size);
}

void read_drive(Table table, const SimKinds& kinds, RobotModel& model) {
  const DriveKind* kind = find_kind(table, kinds.drives);
  if (kind == nullptr) return;
  model.drive = kind;
  model.drive_parameters = table.parameters(kind->descriptor.parameters);
  const auto drive = made(*kind, model.drive_parameters, table);
  if (drive == nullptr) return;
  for (const PortDescriptor& port : kind->descriptor.ports) {
    CommandChannel channel{std::string(port.name), {}};
    for (int n = 0; n < port.size; ++n) channel.elements.push_back(drive->element(static_cast<std::size_t>(n)));
    model.description.commands.push_back(std::move(channel));
  }
}

void describe_channels(const SensorModel& sensor, const Sensor& device, Description& description) {
  std::size_t n = 0, values = 0, at = 0;
  for (const PortDescriptor& port : sensor.kind->descriptor.ports) values += static_cast<std::size_t>(port.size);
  std::vector<double> broken(values);
  device.broken(broken);
  for (const PortDescriptor& port : sensor.kind->descriptor.ports) {
    const Limits limits = device.limits(n);
    const double turn = device.turn(n++);
    const double dead = broken[at];
    at += static_cast<std::size_t>(port.size);
    description.sensations.push_back({.name = sensor.id + "." + std::string(port.name),
                                      .unit = std::string(port.unit),
                                      .type = port.type,
                                      .elements = element_names(port),
                                      .min = limits.min,
                                      .max = limits.max,
                                      .period_s = sensor.period_s,
                                      .dead = dead,
                                      .turn = turn});
  }
  if (!description.body) return;
  Mount mount{sensor.id, std::string(sensor.kind->descriptor.name), sensor.mount};
  if (sensor.kind->descriptor.parameter("cone_deg") != nullptr) {
    mount.cone_rad = Angle::from_deg(sensor.parameters.real("cone_deg")).rad();
  }
  if (const SensationChannel* range = description.sensation(sensor.id + ".range")) mount.max_range_m = range->max;
  description.body->mounts.push_back(std::move(mount));
}

/// A task that stands among the sensors, as files had it before there were tasks. What only a sensor can be told is
/// refused where it says anything; where it sits on the body never mattered.
bool read_old_task(Table& table, const SimKinds& kinds, std::vector<std::string>& ids, RobotModel& model) {
  const config::Value* kind = table.value("kind");
  if (kind == nullptr || kind->string() == nullptr) return false;
  const std::string& name = *kind->string();
  const auto is_task = [&](const TaskKind* one) { return one->descriptor.paper_name == name; };
  if (std::ranges::none_of(kinds.tasks, is_task)) return false;
  for (const ParameterDescriptor& parameter : sensor_parameters()) {
    const std::string key(parameter.name);
    table.known(key);
    const bool tells = key == "period_s" || key == "phase_s" || key == "fault" || key == "fault_from_s";
    if (!tells || !table.has(key)) continue;
    table.problem(key, ErrorCode::BadParameter,
                  {"{} is no sensor any more but a task, which knows no {}: write it as [[task]] without it",
                   "{} ya no es un sensor sino una tarea, que no tiene {}: escríbalo como [[task]] sin ello"},
                  name, key);
  }
  table.note("kind",
             {"{} is a task: [[task]] says so more clearly than [[sensor]]",
              "{} es una tarea: [[task]] lo dice con más claridad que [[sensor]]"},
             name);
  read_task(table, kinds.tasks, ids, model.tasked, model.tasks);
  return true;
}

/// Between 0 and a microsecond lies nothing that times of a run can tell apart.
void check_period(const Table& table, double period_s) {
  if (period_s == 0 || period_s >= kShortestPeriod_s) return;
  table.problem("period_s", ErrorCode::BadParameter,
                {"period_s is {}, must be 0 (a firing for every frame) or >= {}",
                 "period_s es {}, debe ser 0 (un disparo en cada trama) o >= {}"},
                shortest(period_s), shortest(kShortestPeriod_s));
}

void read_sensor(Table& table, const SimKinds& kinds, std::vector<std::string>& ids, RobotModel& model) {
  if (read_old_task(table, kinds, ids, model)) return;
  SensorModel sensor;
  sensor.id = table.text("id");
  table.set_context(sensor.id);
  config::check_name(table, "id", sensor.id, false, ids);
  sensor.kind = find_kind(table, kinds.sensors);
  if (sensor.kind == nullptr) return;
  const auto common = table.parameters(sensor_parameters()).filled<SensorCommon>();
  sensor.mount = {{common.x_m, common.y_m}, common.yaw.wrapped()};
  sensor.period_s = common.period_s;
  check_period(table, sensor.period_s);
  sensor.phase_s = common.phase_s;
  sensor.fault = common.fault;
  sensor.fault_from_s = common.fault_from_s;
  if (model.radius_m > 0 && sensor.mount.position.length() > model.radius_m * (1 + 1e-9)) {
    table.problem("x_m", ErrorCode::BadParameter,
                  {"sits {:.3g} m from the centre, must be on the body: within its radius of {:.3g} m",
                   "está a {:.3g} m del centro, debe estar sobre el cuerpo: dentro de su radio de {:.3g} m"},
                  sensor.mount.position.length(), model.radius_m);
  }
  sensor.parameters = table.parameters(sensor.kind->descriptor.parameters);
  const auto device = made(*sensor.kind, sensor.parameters, table);
  if (device == nullptr) return;
  describe_channels(sensor, *device, model.description);
  model.sensors.push_back(std::move(sensor));
}

void read_battery(Table& root, BatteryModel& battery) {
  const bool present = root.has("battery");
  Table table = root.table("battery");
  const Parameters read = table.parameters(battery_parameters());
  if (!present) return;
  battery = read.filled<BatteryModel>();
  if (battery.empty_V > battery.full_V) {
    table.problem("empty_V", ErrorCode::BadParameter,
                  {"empty_V is {}, must be <= full_V = {}", "empty_V es {}, debe ser <= full_V = {}"}, battery.empty_V,
                  battery.full_V);
  }
}

void read_simulated(Table& root, const SimKinds& kinds, RobotModel& model) {
  if (!root.has("drive")) {
    root.problem("drive", ErrorCode::MissingKey,
                 {"[drive] is missing: a robot with sensors must have one; a bare description has [[sensation]] and "
                  "[[command]] instead",
                  "falta [drive]: un robot con sensores debe tener tracción; una mera descripción tiene en su lugar "
                  "[[sensation]] y [[command]]"});
  } else {
    read_drive(root.table("drive"), kinds, model);
  }
  model.energy = root.table("energy").parameters(energy_parameters()).filled<EnergyModel>();
  read_battery(root, model.battery);
  model.substep_s = root.number("substep_s", 0.01, Range{1e-4, 10});
  std::vector<std::string> ids;
  config::each_table(root, "sensor", [&](Table& table) { read_sensor(table, kinds, ids, model); });
  for (TaskModel& task : read_tasks(root, kinds.tasks, ids, model.tasked)) model.tasks.push_back(std::move(task));
}

/// The robot's own channels, then those of its tasks, which stand in `tasked` alone so far.
void join_tasks(RobotModel& model) {
  std::vector<SensationChannel> of_tasks = std::move(model.tasked.sensations);
  model.tasked = model.description;
  std::ranges::move(of_tasks, std::back_inserter(model.tasked.sensations));
}

}  // namespace

std::shared_ptr<const RobotModel> read_robot(const config::Value& value, const SimKinds& kinds, Problems& problems,
                                             FileReader* files, config::Outline* outline) {
  const std::size_t before = problems.size();
  auto model = std::make_shared<RobotModel>();
  {
    Table root(value, "", problems, outline);
    root.opens_by(files);
    check_format(root);
    model->description.name = root.text("name");
    model->description.tick_s = root.number("tick_s", 0.1, Range{1e-3, 60});
    if (model->description.tick_s > kLongTick_s) {
      root.note("tick_s",
                {"tick_s is {}: a robot drives so long on one look at its sensors",
                 "tick_s es {}: un robot avanza ese tiempo con una sola lectura de sus sensores"},
                shortest(model->description.tick_s) + " s");
    }
    read_body(root, *model);
    if (root.has("sensation") || root.has("command")) {
      read_described(root, model->description);
    } else {
      read_simulated(root, kinds, *model);
    }
  }
  if (problems.size() != before) return nullptr;
  join_tasks(*model);
  return model;
}

std::shared_ptr<const RobotModel> parse_robot(std::string_view text, const std::string& file_name,
                                              const SimKinds& kinds, Problems& problems, config::Outline* outline) {
  const auto value = config::parse(text, file_name);
  if (!value) {
    problems.add(value.error());
    return nullptr;
  }
  return read_robot(*value, kinds, problems, nullptr, outline);
}

}  // namespace ganglion::sim
