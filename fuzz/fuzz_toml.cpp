// The four files people write in TOML. The first byte of an input says which: experiment, controller, robot, world.
// What is rejected must be rejected with a line; what is accepted must be the same after formatting.
#include "fuzz/target.h"
#include "ganglion/config/format.h"
#include "ganglion/config/table.h"
#include "ganglion/graph/controller.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/run/experiment.h"
#include "ganglion/sim/simulation/simulation.h"
#include "ganglion/sim/world/ground.h"

namespace ganglion::fuzz {
namespace {

/// A robot that most wires of the examples fit.
const Description& robot() {
  static const Description kRobot = [] {
    constexpr std::string_view kText =
        "format = 1\nname = \"r\"\ntick_s = 0.1\n[body]\nlength_m = 0.24\nwidth_m = 0.2\n[drive]\nkind = \"Tracked\"\n"
        "[[sensor]]\nid = \"sonar_left\"\nkind = \"Sonar\"\n[[sensor]]\nid = \"sonar_right\"\nkind = \"Sonar\"\n"
        "[[sensor]]\nid = \"compass\"\nkind = \"Compass\"\n[[sensor]]\nid = \"dinsmore\"\nkind = \"DinsmoreCompass\"\n";
    Problems problems;
    const auto model = sim::parse_robot(kText, "robot.toml", sim_kinds(), problems);
    must(model != nullptr, "the target's own robot is good", problems.text());
    return model->description;
  }();
  return kRobot;
}

/// A controller that was accepted must bear any frame.
void tick(Controller& controller) {
  SenseFrame sense = make_sense_frame(robot());
  ActFrame act = make_act_frame(robot());
  constexpr std::array kReadings = {0.3,
                                    std::numeric_limits<double>::quiet_NaN(),
                                    std::numeric_limits<double>::infinity(),
                                    -std::numeric_limits<double>::infinity(),
                                    0.05,
                                    1e300};
  for (std::uint32_t i = 0; i < 12; ++i) {
    sense.tick = i;
    sense.time_s = 0.1 * i;
    sense.cost = 0.1;
    std::fill(sense.values.begin(), sense.values.end(), kReadings[i % kReadings.size()]);
    std::fill(sense.ages_s.begin(), sense.ages_s.end(), 0.0);
    controller.tick(sense, 0.1, act);
    for (const double value : act.values) must(value == value && value - value == 0, "commands are finite");
    controller.grow();
  }
}

void read_controller_text(std::string_view text, Problems& problems) {
  const auto root = config::parse(text, "c.toml");
  if (!root) return problems.add(root.error());
  ControllerModel model = read_controller(*root, controller_kinds(), problems);
  resolve(model, robot(), problems);
  order(model, problems);
  if (!problems.empty()) return;
  auto controller = Controller::compile(model, robot(), controller_kinds(), {});
  if (controller) tick(*controller);
}

void read(int reader, std::string_view text, Problems& problems) {
  DiskFiles files;
  switch (reader) {
    case 0:
      read_experiment(files, put("experiment.toml", text), {}, problems);
      break;
    case 1:
      read_controller_text(text, problems);
      break;
    case 2:
      sim::parse_robot(text, "robot.toml", sim_kinds(), problems);
      break;
    default:
      static_cast<void>(sim::Ground::parse(text, (folder() / "world.toml").string(), problems));
  }
}

}  // namespace

void run_input(std::string_view input) {
  const int reader = choice(input, 4);
  Problems problems;
  read(reader, input, problems);
  for (const Error& error : problems.sorted()) {
    must(!error.place.file.empty() && error.place.line > 0, "every problem has a place", error.text());
  }
  const auto parsed = config::parse(input, "a.toml");
  const auto formatted = config::format(input, "a.toml");
  must(parsed.has_value() == formatted.has_value(), "what can be read can be formatted");
  if (!parsed) return;
  const auto again = config::parse(*formatted, "a.toml");
  must(again && config::equal(*parsed, *again), "formatting changes nothing", *formatted);
}

}  // namespace ganglion::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ganglion::fuzz::run_input({reinterpret_cast<const char*>(data), size});
  return 0;
}
