#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "ganglion/graph/controller.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/module/testing/allocations.h"

namespace ganglion {
namespace {

const PortDescriptor* port_of(const Descriptor& kind, PortRole role) {
  const auto found =
      std::find_if(kind.ports.begin(), kind.ports.end(), [role](const auto& p) { return p.role == role; });
  return found != kind.ports.end() ? &*found : nullptr;
}

/// The first acting kind that needs a request, or none; one that takes set-points only if there is no other.
const Descriptor& acting_kind(bool asked) {
  const Descriptor* second_best = nullptr;
  for (const ActingModuleKind* kind : controller_kinds().acting) {
    const PortDescriptor* request = port_of(kind->descriptor, PortRole::Request);
    if ((request != nullptr) != asked) continue;
    if (request == nullptr || !request->standing) return kind->descriptor;
    second_best = &kind->descriptor;
  }
  return *second_best;
}

/// Draws a small controller round any one kind: a sensation for every input, a goal for a request, behaviours for
/// candidates, an acting module that a goal can ask, a command of the robot for what it commands.
class Drawing {
 public:
  explicit Drawing(const Descriptor& kind) {
    if (kind.component_class != ComponentClass::Goal) {
      add(kind, "subject", true);
      return;
    }
    const Descriptor& asked = acting_kind(true);
    width_ = std::max(port_of(asked, PortRole::Request)->width(), 1);
    goal_ = "subject";
    add(asked, "asked", true);
    add(kind, goal_, false);
  }

  std::string text() const { return "format = 1\n" + text_; }
  const Description& robot() const { return robot_; }

 private:
  std::string sensation(const PortDescriptor& port) {
    const std::string id = "s" + std::to_string(robot_.sensations.size());
    SensationChannel channel{.name = id, .unit = port.unit == "*" ? "" : std::string(port.unit), .type = port.type};
    const int size = port.width() > 0 ? port.width() : width_;
    for (int i = 0; size > 1 && i < size; ++i) channel.elements.push_back("e" + std::to_string(i));
    robot_.sensations.push_back(channel);
    text_ = "[[sensation]]\nid = \"" + id + "\"\nchannel = \"" + id + "\"\n" + text_;
    return "\"" + id + "\"";
  }

  std::string source(const PortDescriptor& port, const std::string& id) {
    if (port.role == PortRole::Request && !goal_.empty()) return "\"" + goal_ + "\"";
    if (port.role == PortRole::Request) {
      std::string zeros = "0";
      for (std::size_t i = 1; i < port.elements.size(); ++i) zeros += ", 0";
      text_ += "[[goal]]\nid = \"" + id + "_goal\"\nkind = \"Constant\"\nvalue = [" + zeros + "]\n";
      return "\"" + id + "_goal\"";
    }
    if (port.role == PortRole::Candidate) {
      for (const char* name : {"first", "second"}) add(acting_kind(false), id + "_" + name, false);
      return "[\"" + id + "_first\", \"" + id + "_second\"]";
    }
    if (port.role == PortRole::Appraisal) return "";  // needs an acting module of that shape
    return port.many ? "[" + sensation(port) + ", " + sensation(port) + "]" : sensation(port);
  }

  void add(const Descriptor& kind, const std::string& id, bool drives) {
    std::string lines;
    for (const PortDescriptor& port : kind.ports) {
      if (!is_input(kind.component_class, port.role)) continue;
      const std::string from = source(port, id);
      if (!from.empty()) lines += "in." + std::string(port.name) + " = " + from + "\n";
    }
    for (const ParameterDescriptor& parameter : kind.parameters) {
      if (parameter.type != ParameterType::Reals || parameter.unit != "*") continue;  // as many as are asked for
      lines += std::string(parameter.name) + " = [0";
      for (int i = 1; i < width_; ++i) lines += ", 0";
      lines += "]\n";
    }
    const Descriptor& commander = kind.component_class == ComponentClass::Coordinator ? acting_kind(false) : kind;
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
  std::string goal_;  // that asks for something
  int width_ = 1;     // of what takes any number of values
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
    for (const Descriptor* kind : descriptors_of(controller_kinds(), one)) kinds.push_back(kind);
  }
  return kinds;
}

/// A test for each kind there is, named after it: whoever adds one sees it walked.
class OfControllers : public ::testing::TestWithParam<const Descriptor*> {};

TEST_P(OfControllers, TicksOnAnyReadingsWithoutAllocatingAndRepeatsItself) {
  const std::string kind(GetParam()->name);
  const Drawing drawing(*GetParam());
  Controller one = compiled(drawing, kind), twin = compiled(drawing, kind);
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
    ASSERT_EQ(testing::allocations(), before) << "allocates in tick " << tick;
    for (const double value : act.values) ASSERT_LE(std::fabs(value), 10) << "at tick " << tick;
    one.grow();
    twin.tick(sense, 0.1, act);
    twin.grow();
  }
  EXPECT_EQ(one.digest().total(), twin.digest().total()) << "does not repeat itself";
}

INSTANTIATE_TEST_SUITE_P(EveryKind, OfControllers, ::testing::ValuesIn(kinds_of_controllers()),
                         [](const auto& one) { return std::string(one.param->name); });

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
