#include "ganglion/sim/robot/robot_model.h"

#include <cmath>

#include "ganglion/base/text.h"
#include "ganglion/sim/robot/robot_reader.h"

namespace ganglion::sim {
namespace {

using config::Range;
using config::Table;

constexpr Range kSize{1e-3, 100};

/// The kind of that name; a problem with the nearest names if there is none.
template <class Product>
const Kind<Product>* find_kind(Table& table, std::span<const Kind<Product>* const> kinds) {
  const std::string name = table.text("kind");
  std::vector<std::string> names;
  for (const auto* kind : kinds) {
    if (!name.empty() && (kind->descriptor.name == name || kind->descriptor.paper_name == name)) {
      table.is_of(kind->descriptor);
      return kind;
    }
    names.emplace_back(kind->descriptor.name);
  }
  if (table.has("kind") && !name.empty()) {
    const Sentence what =
        say({"there is no kind \"{}\"{}", "no existe el tipo \"{}\"{}"}, name, suggestion(name, names));
    table.problem("kind", Error{ErrorCode::UnknownKey, what, {}, Subject{.found = name, .choices = names}});
  }
  // Its parameters cannot be told from slips: only the kind is reported.
  for (const std::string& key : table.keys()) table.known(key);
  return nullptr;
}

/// A device of that kind, to see whether its parameters agree; null with a problem if they do not.
template <class Product>
std::unique_ptr<Product> made(const Kind<Product>& kind, const Parameters& parameters, const Table& table) {
  auto product = kind.make(parameters);
  if (product) return std::move(*product);
  table.problem("kind", product.error());
  return nullptr;
}

void read_body(Table& root, RobotModel& model) {
  if (!root.has("body")) {
    root.problem(
        "body", ErrorCode::MissingKey,
        {"[body] is missing: length_m and width_m of the robot", "falta [body]: length_m y width_m del robot"});
    return;
  }
  const std::size_t before = root.problems().size();
  Table body = root.table("body");
  RobotDescription& description = model.description;
  description.length_m = body.number("length_m", kSize);
  description.width_m = body.number("width_m", kSize);
  const double half_diagonal_m =
      std::sqrt(description.length_m * description.length_m + description.width_m * description.width_m) / 2;
  model.climb_rad = Angle::from_deg(body.number("climb_deg", 90, Range{0, 90})).rad();
  model.tip_rad = Angle::from_deg(body.number("tip_deg", 90, Range{0, 90})).rad();
  const double radius_m = body.number("radius_m", half_diagonal_m, kSize);
  if (root.problems().size() == before) model.radius_m = radius_m;  // else mounts cannot be judged
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

void describe_channels(const SensorModel& sensor, const Sensor& device, RobotDescription& description) {
  std::size_t n = 0, values = 0, at = 0;
  for (const PortDescriptor& port : sensor.kind->descriptor.ports) values += static_cast<std::size_t>(port.size);
  std::vector<double> broken(values);
  device.broken(broken);
  for (const PortDescriptor& port : sensor.kind->descriptor.ports) {
    const Limits limits = device.limits(n++);
    const double dead = broken[at];
    at += static_cast<std::size_t>(port.size);
    description.sensations.push_back({.name = sensor.id + "." + std::string(port.name),
                                      .unit = std::string(port.unit),
                                      .type = port.type,
                                      .elements = element_names(port),
                                      .min = limits.min,
                                      .max = limits.max,
                                      .period_s = sensor.period_s,
                                      .mount = sensor.mount,
                                      .dead = dead});
  }
}

void read_sensor(Table& table, const SimKinds& kinds, std::vector<std::string>& ids, RobotModel& model) {
  SensorModel sensor;
  sensor.id = table.text("id");
  table.set_context(sensor.id);
  check_name(table, "id", sensor.id, false, ids);
  sensor.kind = find_kind(table, kinds.sensors);
  if (sensor.kind == nullptr) return;
  const auto common = table.parameters(sensor_parameters()).filled<SensorCommon>();
  sensor.mount = {{common.x_m, common.y_m}, common.yaw.wrapped()};
  sensor.period_s = common.period_s;
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
  model.trained = model.trained || device->trainer_log() != nullptr;
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
  each_table(root, "sensor", [&](Table& table) { read_sensor(table, kinds, ids, model); });
}

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
    read_body(root, *model);
    if (root.has("sensation") || root.has("command")) {
      read_described(root, model->description);
    } else {
      read_simulated(root, kinds, *model);
    }
  }
  if (problems.size() != before) return nullptr;
  return model;
}

}  // namespace

std::shared_ptr<const RobotModel> load_robot(FileReader& files, int file, const SimKinds& kinds,
                                             std::span<const config::Override> overrides, Problems& problems) {
  auto value = config::parse(files.at(file));
  if (!value) {
    problems.add(value.error());
    return nullptr;
  }
  const std::size_t before = problems.size();
  for (const config::Override& override : overrides) {
    const auto applied = config::apply(*value, override);
    if (!applied) problems.add(applied.error());
  }
  auto model = read_robot(*value, kinds, problems, &files, nullptr);
  return problems.size() == before ? model : nullptr;
}

std::shared_ptr<const RobotModel> load_robot(const std::filesystem::path& path, const SimKinds& kinds,
                                             std::span<const config::Override> overrides, Problems& problems) {
  DiskFiles files;
  const auto file = files.open("robot", path.string(), -1, config::kMaxBytes);
  if (file) return load_robot(files, *file, kinds, overrides, problems);
  problems.add(file.error());
  return nullptr;
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

std::optional<RobotDescription> load_description(FileReader& files, int file, const SimKinds& kinds,
                                                 std::span<const config::Override> overrides, Problems& problems) {
  const auto model = load_robot(files, file, kinds, overrides, problems);
  return model != nullptr ? std::optional(model->description) : std::nullopt;
}

std::optional<RobotDescription> load_description(const std::filesystem::path& path, const SimKinds& kinds,
                                                 std::span<const config::Override> overrides, Problems& problems) {
  const auto model = load_robot(path, kinds, overrides, problems);
  return model != nullptr ? std::optional(model->description) : std::nullopt;
}

}  // namespace ganglion::sim
