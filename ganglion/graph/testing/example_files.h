#pragma once

#include <array>
#include <string>

#include "ganglion/graph/controller.h"
#include "ganglion/graph/testing/example_kinds.h"

/// Good controller files of the example kinds, and what the graph says of others.
namespace ganglion::example {

/// Everything that is wrong with a controller file; nothing where it compiles.
inline Problems problems_of(const config::Value& file) {
  Problems problems;
  ControllerModel model = read_controller(file, kKinds, problems);
  resolve(model, robot(), problems);
  if (!problems.empty()) return problems;
  if (const auto made = Controller::compile(model, robot(), kKinds, {}); !made) problems.add(made.error());
  return problems;
}

/// The same as a person is told.
inline std::string complaints(std::string_view text) {
  const auto file = config::parse(text, "c.toml");
  return file ? problems_of(*file).text() : file.error().text() + "\n";
}

/// Two behaviours, or rather one and a goal, below a coordinator.
inline const std::string kArbiter = R"(format = 1
name = "Example"
robot = "robot.toml"

[[sensation]]
id = "sonar_left"
channel = "sonar_left.range"

[[sensation]]
id = "sonar_right"
channel = "sonar_right.range"

[[sensation]]
id = "position"
channel = "odometry.position"

[[sensing]]
id = "nearest"
kind = "Nearest"
in.ranges = ["sonar_left", "sonar_right"]

[[goal]]
id = "charger"
kind = "Target"
at_m = [1, 2]

[[acting]]
id = "back_off"
kind = "BackOff"
in.left = "sonar_left"
in.right = "sonar_right"
trigger_range_m = 0.2

[[acting]]
id = "go"
kind = "GoTo"
in.request = "charger"
in.position = "position"

[[coordinator]]
id = "arbiter"
kind = "First"
in.commands = ["back_off", "go"]
command = "drive"
)";

/// The least there is, with comments, an `in` table of its own and a layout.
inline const std::string kBehaviour = R"(# One behaviour alone.
format = 1
tick_s = 0.1  # ten a second

[[sensation]]
id = "ahead"
channel = "sonar_left.range"

# Goes back where it must.
[[acting]]
id = "escape"
kind = "AmBk"   # by its name in the paper
side = "freer"
bursts = 2
loud = true
label = 'it says "back"'
command = "drive"

[acting.in]
left = "ahead"
right = "ahead@previous"

[layout]
escape = { x = 100, y = -20.5 }
ahead = [0, 0]
)";

/// Values of the tick before, single elements, expectations and a goal that may not be taken over.
inline const std::string kLoops = R"(format = 1
name = """
Loops
"""

[[sensation]]
id = "where"
channel = "odometry.position"

[[sensation]]
id = "compass"
channel = "compass.heading"

[[sensing]]
id = "memory"
kind = "Nearest"
in.ranges = [
  "memory.range@previous",  # itself
  "where.x",
]
in.expected = "go.expected"

[[goal]]
id = "dock"
kind = "Target"
priority_class = 0x3

[[goal]]
id = "tour"
kind = "Target"
at_m = [1_0, -2.5e-1]

[[acting]]
id = "go"
kind = "GoTo"
in.request = ["dock", "tour"]
in.position = "where"
tolerance = 0.05
preemption = false

[[acting]]
id = "off"
kind = "BackOff"
in = { left = "memory.range", right = "where.y", heading = "compass" }

[[coordinator]]
id = "one"
kind = "First"
in.commands = ["off", "go"]
command = "drive"
)";

}  // namespace ganglion::example
