#include "ganglion/graph/testing/rig.h"

#include <algorithm>
#include <cstdio>

namespace ganglion::testing {
namespace {

constexpr double kStep_s = 0.1;

Controller must_compile(std::string_view text, const Identity& identity) {
  Problems problems;
  auto controller = compiled(text, problems, test_robot(), identity);
  if (!controller) std::fprintf(stderr, "%s", problems.text().c_str());
  expects(controller.has_value());
  return std::move(*controller);
}

}  // namespace

Description test_robot() {
  Description robot;
  robot.name = "test";
  robot.sensations = {
      {.name = "place", .unit = "m"},
      {.name = "heading", .unit = "rad", .type = ValueType::Circular},
      {.name = "cell", .type = ValueType::Discrete, .elements = {"column", "row"}},
      {.name = "pair", .elements = {"x", "y"}},
      {.name = "a"},
      {.name = "b"},
      {.name = "c"},
      {.name = "d"},
  };
  robot.commands = {
      {"drive", {{.name = "left"}, {.name = "right"}}},
      {"move", {{.name = "x", .min = -10, .max = 10}}},
      {"grip", {{.name = "force", .unit = "N", .min = 0, .max = 5, .safe = 2}}},
  };
  return robot;
}

Result<Controller> compiled(std::string_view text, Problems& problems, const Description& robot,
                            const Identity& identity) {
  const auto value = config::parse("format = 1\n" + std::string(text), "controller.toml");
  if (!value) {
    problems.add(value.error());
    return tl::unexpected<Error>(value.error());
  }
  ControllerModel model = read_controller(*value, kinds(), problems);
  resolve(model, robot, problems);
  if (!problems.empty()) return tl::unexpected<Error>(problems.sorted().front());
  auto controller = Controller::compile(model, robot, kinds(), identity);
  if (!controller) problems.add(controller.error());
  return controller;
}

std::string problems_of(std::string_view text) {
  Problems problems;
  (void)compiled(text, problems);
  return problems.text();
}

Rig::Rig(std::string_view text, const Identity& identity)
    : sense(make_sense_frame(test_robot())),
      act(make_act_frame(test_robot())),
      controller(must_compile(text, identity)),
      robot_(test_robot()) {
  std::fill(sense.values.begin(), sense.values.end(), 0.0);
  std::fill(sense.ages_s.begin(), sense.ages_s.end(), 0.0);
}

void Rig::set(std::string_view channel, std::initializer_list<double> values) {
  const SensationChannel* found = robot_.sensation(std::string(channel));
  expects(found != nullptr && values.size() == static_cast<std::size_t>(found->size()));
  const int offset = robot_.sensation_offset(static_cast<std::size_t>(found - robot_.sensations.data()));
  std::copy(values.begin(), values.end(), sense.values.begin() + offset);
}

void Rig::age(std::string_view channel, double age_s) {
  const SensationChannel* found = robot_.sensation(std::string(channel));
  expects(found != nullptr);
  sense.ages_s[static_cast<std::size_t>(found - robot_.sensations.data())] = age_s;
}

void Rig::tick() {
  ++sense.tick;
  sense.time_s = kStep_s * sense.tick;
  sense.cost = cost;
  controller.tick(sense, kStep_s, act);
  controller.grow();
}

double Rig::signal(std::string_view name) const {
  const auto& signals = controller.signals();
  const auto found = std::find_if(signals.begin(), signals.end(), [&](const Signal& s) { return s.name == name; });
  if (found == signals.end()) std::fprintf(stderr, "no signal %s\n", std::string(name).c_str());
  expects(found != signals.end());
  return controller.values()[static_cast<std::size_t>(found - signals.begin())];
}

int Rig::index(std::string_view id) const {
  for (int i = 0; i < controller.components(); ++i) {
    if (controller.id(i) == id) return i;
  }
  expects(false);
  return -1;
}

std::uint64_t Rig::digest(std::string_view id) const {
  return controller.digest().of(static_cast<std::size_t>(index(id)));
}

std::size_t Rig::channel_index(std::string_view channel) const {
  const CommandChannel* found = robot_.command(std::string(channel));
  expects(found != nullptr);
  return static_cast<std::size_t>(found - robot_.commands.data());
}

double Rig::command(std::string_view channel, std::size_t element) const {
  const auto offset = static_cast<std::size_t>(robot_.command_offset(channel_index(channel)));
  return act.values[offset + element];
}

}  // namespace ganglion::testing
