#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "ganglion/graph/controller.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/module/testing/allocations.h"

namespace ganglion {
namespace {

/// Draws a small controller round any one kind: a sensation for every input, a goal for a request, behaviours for
/// candidates, a command of the robot for what it commands.
class Drawing {
 public:
  explicit Drawing(const Descriptor& kind) { add(kind, "subject", true); }

  std::string text() const { return "format = 1\n" + text_; }
  const Description& robot() const { return robot_; }

 private:
  std::string sensation(const PortDescriptor& port) {
    const std::string id = "s" + std::to_string(robot_.sensations.size());
    SensationChannel channel{.name = id, .unit = port.unit == "*" ? "" : std::string(port.unit), .type = port.type};
    const int size = std::max(port.width(), 1);
    for (int i = 0; size > 1 && i < size; ++i) channel.elements.push_back("e" + std::to_string(i));
    robot_.sensations.push_back(channel);
    text_ = "[[sensation]]\nid = \"" + id + "\"\nchannel = \"" + id + "\"\n" + text_;
    return "\"" + id + "\"";
  }

  std::string source(const PortDescriptor& port, const std::string& id) {
    if (port.role == PortRole::Request) {
      std::string zeros = "0";
      for (std::size_t i = 1; i < port.elements.size(); ++i) zeros += ", 0";
      text_ += "[[goal]]\nid = \"" + id + "_goal\"\nkind = \"Constant\"\nvalue = [" + zeros + "]\n";
      return "\"" + id + "_goal\"";
    }
    if (port.role == PortRole::Candidate) {
      for (const char* name : {"first", "second"}) add(*behaviour(), id + "_" + name, false);
      return "[\"" + id + "_first\", \"" + id + "_second\"]";
    }
    if (port.role == PortRole::Appraisal) return "";  // needs an acting module of that shape
    return port.many ? "[" + sensation(port) + ", " + sensation(port) + "]" : sensation(port);
  }

  static const Descriptor* behaviour() {
    for (const ActingModuleKind* kind : controller_kinds().acting) {
      bool asks = false;
      for (const PortDescriptor& port : kind->descriptor.ports) asks = asks || port.role == PortRole::Request;
      if (!asks) return &kind->descriptor;
    }
    return nullptr;
  }

  void add(const Descriptor& kind, const std::string& id, bool drives) {
    std::string lines;
    for (const PortDescriptor& port : kind.ports) {
      if (!is_input(kind.component_class, port.role)) continue;
      const std::string from = source(port, id);
      if (!from.empty()) lines += "in." + std::string(port.name) + " = " + from + "\n";
    }
    const Descriptor& commander = kind.component_class == ComponentClass::Coordinator ? *behaviour() : kind;
    for (const PortDescriptor& port : commander.ports) {
      if (port.role != PortRole::Command || !drives) continue;
      CommandChannel channel{"out", {}};
      for (const std::string& element : element_names(port)) channel.elements.push_back({element, "", -10, 10, 0});
      for (int i = static_cast<int>(channel.elements.size()); i < port.size; ++i) {
        channel.elements.push_back({"value" + std::to_string(i), "", -10, 10, 0});
      }
      robot_.commands.push_back(channel);
      lines += "command = \"out\"\n";
    }
    text_ += "[[" + std::string(name_of(kind.component_class)) + "]]\nid = \"" + id + "\"\nkind = \"" +
             std::string(kind.name) + "\"\n" + lines;
  }

  std::string text_;
  Description robot_;
};

/// Readings that REP-117 knows, ordinary ones, and one that nothing should believe.
void draw(std::vector<double>& values, Draws& draws) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  constexpr std::array kReadings = {std::nan(""), kInf, -kInf, 0.0, 1.0, 0.05, 2.0, -3.0, 1e300, 0.4};
  for (double& value : values) value = kReadings[draws.below(kReadings.size())];
}

Controller compiled(const Drawing& drawing, const std::string& name) {
  Problems problems;
  const auto root = config::parse(drawing.text(), name);
  EXPECT_TRUE(root) << root.error().text();
  ControllerModel model = read_controller(*root, controller_kinds(), problems);
  resolve(model, drawing.robot(), problems);
  EXPECT_TRUE(problems.empty()) << problems.text() << drawing.text();
  auto made = Controller::compile(model, drawing.robot(), controller_kinds(), {.seed = 3});
  EXPECT_TRUE(made) << made.error().text();
  return std::move(*made);
}

std::vector<const Descriptor*> kinds_of_controllers() {
  std::vector<const Descriptor*> kinds;
  for (const auto one :
       {ComponentClass::Sensing, ComponentClass::Goal, ComponentClass::Acting, ComponentClass::Coordinator}) {
    for (const Descriptor* kind : descriptors_of(controller_kinds(), one)) {
      if (kind->name != "App" && kind->name != "Constant") kinds.push_back(kind);  // covered as goals of the others
    }
  }
  return kinds;
}

TEST(EveryKind, TicksOnAnyReadingsWithoutAllocatingAndRepeatsItself) {
  for (const Descriptor* kind : kinds_of_controllers()) {
    const Drawing drawing(*kind);
    Controller one = compiled(drawing, std::string(kind->name)), twin = compiled(drawing, std::string(kind->name));
    SenseFrame sense = make_sense_frame(drawing.robot());
    ActFrame act = make_act_frame(drawing.robot());
    for (std::uint32_t tick = 0; tick < 400; ++tick) {
      Draws draws({.seed = 5}, tick);
      draw(sense.values, draws);
      sense.tick = tick;
      sense.time_s = 0.1 * tick;
      std::fill(sense.ages_s.begin(), sense.ages_s.end(), 0.0);
      sense.cost = tick > 0 ? std::optional<double>(0.5) : std::nullopt;
      const std::uint64_t before = testing::allocations();
      one.tick(sense, 0.1, act);
      ASSERT_EQ(testing::allocations(), before) << kind->name << " allocates in tick " << tick;
      for (const double value : act.values) ASSERT_LE(std::fabs(value), 10) << kind->name << " at tick " << tick;
      one.grow();
      twin.tick(sense, 0.1, act);
      twin.grow();
    }
    EXPECT_EQ(one.digest().total(), twin.digest().total()) << kind->name << " does not repeat itself";
  }
}

TEST(EveryKind, SaysEverythingInBothLanguages) {
  for (const Descriptor* kind : all_descriptors()) {
    EXPECT_FALSE(kind->summary.empty()) << kind->name;
    EXPECT_FALSE(kind->source.empty()) << kind->name;
    for (const PortDescriptor& port : kind->ports) {
      EXPECT_FALSE(port.help.empty()) << kind->name << "." << port.name;
    }
    for (const ParameterDescriptor& parameter : kind->parameters) {
      EXPECT_FALSE(parameter.help.empty()) << kind->name << "." << parameter.name;
      EXPECT_LE(parameter.min, parameter.max) << kind->name << "." << parameter.name;
    }
  }
}

}  // namespace
}  // namespace ganglion
