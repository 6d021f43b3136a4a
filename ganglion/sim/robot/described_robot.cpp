#include <array>
#include <cmath>

#include "ganglion/base/text.h"
#include "ganglion/module/tick/command.h"
#include "ganglion/sim/robot/robot_reader.h"

namespace ganglion::sim {
namespace {

using config::Range;
using config::Table;

constexpr std::array<std::string_view, 3> kTypes = {"real", "discrete", "circular"};

/// A bearing in degrees or counts says what a turn of it is; one that is circular without is an angle in radians.
void read_turn(Table& table, SensationChannel& channel) {
  channel.turn = table.number("turn", 0, config::kNotNegative);
  const bool limited = std::isfinite(channel.max - channel.min);
  if (channel.turn > 0 && limited && channel.max - channel.min > channel.turn) {
    table.problem("turn", ErrorCode::BadParameter,
                  {"turn is {}, must be >= max - min = {}", "turn es {}, debe ser >= max - min = {}"},
                  shortest(channel.turn), shortest(channel.max - channel.min));
  }
  if (channel.turn > 0 || channel.type != ValueType::Circular || channel.unit.empty() || channel.unit == "rad") return;
  table.note(
      "type",
      {"a circular value in {} is taken for an angle in radians: write turn = 360, or what else a full turn counts",
       "un valor circular en {} se toma por un ángulo en radianes: escriba turn = 360, o lo que valga una vuelta"},
      channel.unit);
}

void read_sensation(Table& table, std::vector<std::string>& names, Description& description) {
  SensationChannel channel;
  channel.name = table.text("name");
  table.set_context(channel.name);
  config::check_name(table, "name", channel.name, true, names);
  channel.unit = table.text("unit", "");
  channel.type = static_cast<ValueType>(table.choice("type", kTypes, 0));
  channel.elements = table.texts("elements");
  const Limits all;
  channel.min = table.number("min", all.min);
  channel.max = table.number("max", all.max);
  if (!(channel.min <= channel.max)) {
    table.problem("max", ErrorCode::BadParameter, {"max is {}, must be >= min = {}", "max es {}, debe ser >= min = {}"},
                  shortest(channel.max), shortest(channel.min));
  }
  channel.period_s = table.number("period_s", 0, config::kNotNegative);
  read_turn(table, channel);
  Mount mount{.device = channel.name};
  mount.pose = {{table.number("x_m", 0), table.number("y_m", 0)},
                Angle::from_deg(table.number("yaw_deg", 0, Range{-360, 360})).wrapped()};
  if (description.body) description.body->mounts.push_back(std::move(mount));
  description.sensations.push_back(std::move(channel));
}

void read_command(Table& table, std::vector<std::string>& names, Description& description) {
  CommandChannel channel;
  channel.name = table.text("name");
  table.set_context(channel.name);
  config::check_name(table, "name", channel.name, true, names);
  auto elements = table.texts("elements");
  if (elements.empty()) elements.push_back(channel.name);
  const std::size_t count = elements.size();
  if (count > static_cast<std::size_t>(kMaxCommandValues)) {
    table.problem("elements", ErrorCode::TooLarge,
                  {"has {} elements; the limit is {}", "tiene {} elementos; el límite es {}"}, count,
                  kMaxCommandValues);
  }
  auto units = table.texts("units");
  if (!units.empty() && units.size() != count) {
    table.problem("units", ErrorCode::BadParameter,
                  {"units has {} texts, must have one for each of {} elements",
                   "units tiene {} textos, debe tener uno por cada uno de los {} elementos"},
                  units.size(), count);
  }
  units.resize(count);
  const auto min = table.numbers("min", std::vector<double>(count, -1), count);
  const auto max = table.numbers("max", std::vector<double>(count, 1), count);
  const auto safe = table.numbers("safe", std::vector<double>(count, 0), count);
  for (std::size_t n = 0; n < count; ++n) {
    if (!(min[n] <= safe[n] && safe[n] <= max[n])) {
      table.problem("safe", ErrorCode::BadParameter,
                    {"{}: safe is {}, must be in [{}, {}]", "{}: safe es {}, debe estar en [{}, {}]"}, elements[n],
                    shortest(safe[n]), shortest(min[n]), shortest(max[n]));
    }
    channel.elements.push_back({elements[n], units[n], min[n], max[n], safe[n]});
  }
  description.commands.push_back(std::move(channel));
}

}  // namespace

void read_described(Table& root, Description& description) {
  for (const char* key : {"drive", "sensor", "energy", "battery", "substep_s", "task"}) {
    if (root.has(key)) {
      root.problem(key, ErrorCode::BadParameter,
                   {"{} does not go with [[sensation]] and [[command]]: a robot is either simulated or described",
                    "{} no va con [[sensation]] y [[command]]: un robot es simulado o descrito"},
                   key);
    }
    root.known(key);
  }
  for (const char* key : {"sensation", "command"}) {  // either of them makes it this form: to editors it is required
    if (root.has(key)) root.asks(key, {.form = config::Asked::Form::Tables, .required = true});
  }
  std::vector<std::string> sensations, commands;
  config::each_table(root, "sensation", [&](Table& table) { read_sensation(table, sensations, description); });
  config::each_table(root, "command", [&](Table& table) { read_command(table, commands, description); });
}

}  // namespace ganglion::sim
