#pragma once

#include <array>

#include "ganglion/application/description.h"
#include "ganglion/graph/kind_list.h"

/// A few small kinds and a robot, for the tests of what the graph says and accepts. They do next to nothing.
namespace ganglion::example {

inline constexpr std::array<ElementDescriptor, 2> kPlane = {"x", "y"};
inline constexpr std::array<ElementDescriptor, 2> kTracks = {"left", "right"};
inline constexpr std::array<std::string_view, 3> kSides = {"left", "right", "freer"};
inline constexpr std::array<double, 2> kOrigin = {0, 0};

class Nearest final : public SensingModule {
  void perceive(const Feedback& feedback) noexcept override { put(0, feedback.value(0)); }
};

class Target final : public GlobalGoal {
  Bid bid(const Feedback&) noexcept override { return {}; }
};

class Quiet final : public ActingModule {
  void internal_adaptation(const Feedback&, Cost) noexcept override {}
  Command internal_propagation(const Request&, const Feedback&) noexcept override { return Command::inactive(); }
};

class First final : public Coordinator {
  Command coordinate(const Feedback&, std::span<const Command* const> candidates, std::span<double>) noexcept override {
    return candidates.empty() ? Command::inactive() : *candidates.front();
  }
};

template <class Product, class Made>
Result<std::unique_ptr<Product>> make(const Parameters&) {
  return std::unique_ptr<Product>(std::make_unique<Made>());
}

inline constexpr std::array kNearestPorts = {
    PortDescriptor{.name = "ranges", .unit = "m", .many = true, .help = {"Ranges to choose from", "Distancias"}},
    PortDescriptor{.name = "expected", .role = PortRole::Appraisal, .unit = "m", .required = false},
    PortDescriptor{.name = "range", .role = PortRole::Output, .unit = "m", .help = {"The least", "La menor"}},
    PortDescriptor{.name = "bearing", .role = PortRole::Output, .unit = "rad", .type = ValueType::Circular}};
inline constexpr std::array kTargetParameters = {
    ParameterDescriptor{.name = "at_m", .type = ParameterType::Reals, .unit = "m", .preset_reals = kOrigin, .count = 2},
    ParameterDescriptor{.name = "priority_class", .type = ParameterType::Integer, .min = 0, .max = 9}};
inline constexpr std::array kBackPorts = {
    PortDescriptor{.name = "left", .unit = "m", .help = {"Range on the left", "Distancia a la izquierda"}},
    PortDescriptor{.name = "right", .unit = "m", .help = {"Range on the right", "Distancia a la derecha"}},
    PortDescriptor{.name = "heading", .unit = "rad", .type = ValueType::Circular, .required = false},
    PortDescriptor{.name = "drive", .role = PortRole::Command, .elements = kTracks}};
inline constexpr std::array kBackParameters = {
    ParameterDescriptor{.name = "trigger_range_m",
                        .unit = "m",
                        .preset = 0.1,
                        .min = 0,
                        .max = 3,
                        .help = {"Backs off nearer than this", "Retrocede si hay algo más cerca"},
                        .ours = true},
    ParameterDescriptor{.name = "side", .type = ParameterType::Choice, .preset = 2, .choices = kSides},
    ParameterDescriptor{.name = "bursts", .type = ParameterType::Integer, .preset = 3, .min = 1, .max = 10},
    ParameterDescriptor{.name = "loud", .type = ParameterType::Boolean},
    ParameterDescriptor{.name = "label", .type = ParameterType::Word, .preset_word = "a | b"}};
inline constexpr std::array kGoToPorts = {
    PortDescriptor{.name = "request", .role = PortRole::Request, .unit = "m", .elements = kPlane},
    PortDescriptor{.name = "position", .unit = "m", .elements = kPlane},
    PortDescriptor{.name = "expected", .role = PortRole::Appraisal, .unit = "m", .required = false},
    PortDescriptor{.name = "drive", .role = PortRole::Command, .elements = kTracks}};
inline constexpr std::array kFirstPorts = {
    PortDescriptor{.name = "commands", .role = PortRole::Candidate, .unit = "*", .size = 0, .many = true},
    PortDescriptor{.name = "command", .role = PortRole::Command, .unit = "*", .size = 0}};

inline constexpr SensingModuleKind kNearest = {
    {.component_class = ComponentClass::Sensing, .name = "Nearest", .ports = kNearestPorts, .source = "ours"},
    make<SensingModule, Nearest>};
inline constexpr GlobalGoalKind kTarget = {
    {.component_class = ComponentClass::Goal, .name = "Target", .parameters = kTargetParameters},
    make<GlobalGoal, Target>};
inline constexpr ActingModuleKind kBack = {{.name = "BackOff",
                                            .paper_name = "AmBk",
                                            .summary = {"Backs off from what is near", "Retrocede ante lo cercano"},
                                            .ports = kBackPorts,
                                            .parameters = kBackParameters,
                                            .source = "A paper, section 2"},
                                           make<ActingModule, Quiet>};
inline constexpr ActingModuleKind kGoTo = {{.name = "GoTo", .ports = kGoToPorts}, make<ActingModule, Quiet>};
inline constexpr CoordinatorKind kFirst = {
    {.component_class = ComponentClass::Coordinator, .name = "First", .ports = kFirstPorts}, make<Coordinator, First>};

inline constexpr std::array<const SensingModuleKind*, 1> kSensing = {&kNearest};
inline constexpr std::array<const GlobalGoalKind*, 1> kGoals = {&kTarget};
inline constexpr std::array<const ActingModuleKind*, 2> kActing = {&kBack, &kGoTo};
inline constexpr std::array<const CoordinatorKind*, 1> kCoordinators = {&kFirst};
inline constexpr KindList kKinds = {kSensing, kGoals, kActing, kCoordinators};

inline RobotDescription robot() {
  RobotDescription robot;
  robot.name = "Example";
  robot.sensations = {{"sonar_left.range", "m"},
                      {"sonar_right.range", "m"},
                      {"compass.heading", "rad", ValueType::Circular},
                      {"odometry.position", "m", ValueType::Real, {"x", "y"}}};
  robot.commands = {{"drive", {{"left"}, {"right"}}}, {"arm", {{"lift"}}}};
  return robot;
}

}  // namespace ganglion::example
