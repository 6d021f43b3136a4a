#include "ganglion/sim/robot/robot_schema.h"

#include "ganglion/config/outline_schema.h"

namespace ganglion::sim {
namespace {

/// Either list makes a robot a described one. Bodies differ from that of simulated() and the commands differ in their
/// elements (without a list a sample's has one), so that defaults that follow from other keys are told from fixed ones.
constexpr std::string_view kSensations = R"(format = 1
name = "described"
[body]
length_m = 0.4
width_m = 0.3
[[sensation]]
name = "range"
)";
constexpr std::string_view kCommands = R"(format = 1
name = "described"
[body]
length_m = 0.4
width_m = 0.3
[[command]]
name = "tracks"
elements = ["left", "right"]
)";

/// A robot with this drive, a sensor and a task of each kind.
std::string simulated(const DriveKind& drive, const SimKinds& kinds) {
  std::string text =
      fmt::format("format = 1\nname = \"simulated\"\n[body]\nlength_m = 0.2\nwidth_m = 0.2\n[drive]\nkind = \"{}\"\n",
                  drive.descriptor.name);
  for (const SensorKind* sensor : kinds.sensors) {
    text += fmt::format("[[sensor]]\nid = \"{0}\"\nkind = \"{0}\"\n", sensor->descriptor.name);
  }
  for (const TaskKind* task : kinds.tasks) {
    text += fmt::format("[[task]]\nid = \"{0}\"\nkind = \"{0}\"\n", task->descriptor.name);
  }
  return text;
}

}  // namespace

std::list<config::Outline> robot_outlines(const SimKinds& kinds) {
  std::list<config::Outline> samples;
  Problems problems;  // of kinds whose defaults do not agree: what they ask is known by then
  for (const DriveKind* drive : kinds.drives) {
    parse_robot(simulated(*drive, kinds), "sample", kinds, problems, &samples.emplace_back());
  }
  parse_robot(kSensations, "sample", kinds, problems, &samples.emplace_back());
  parse_robot(kCommands, "sample", kinds, problems, &samples.emplace_back());
  return samples;
}

std::string robot_schema(const SimKinds& kinds) { return config::schema_text("Ganglion robot", robot_outlines(kinds)); }

}  // namespace ganglion::sim
