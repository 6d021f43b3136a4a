#pragma once

#include <array>
#include <string>
#include <vector>

#include "ganglion/application/description.h"
#include "ganglion/graph/kind_list.h"
#include "ganglion/graph/testing/described.h"

/// A few small kinds and a robot, for the tests of what the graph says and accepts. They do next to nothing.
namespace ganglion::example {

inline constexpr std::array<ElementDescriptor, 2> kPlane = {"x", "y"};
inline constexpr std::array<ElementDescriptor, 2> kTracks = {"left", "right"};
inline constexpr std::array<std::string_view, 3> kSides = {"left", "right", "freer"};

struct TargetConfig {
  std::vector<double> at_m = {0, 0};
};

struct BackConfig {
  enum class Side { Left, Right, Freer };
  double trigger_range_m = 0.1;
  Side side = Side::Freer;
  int bursts = 3;
  bool loud = false;
  std::string label = "a | b";
};

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

inline constexpr std::array kNearestPorts = {PortDescriptor{.name = "ranges",
                                                            .title = Text::same("ranges"),
                                                            .help = {"Ranges to choose from", "Distancias"},
                                                            .unit = "m",
                                                            .many = true},
                                             testing::optional(testing::port("expected", PortRole::Appraisal, "m")),
                                             PortDescriptor{.name = "range",
                                                            .title = Text::same("range"),
                                                            .help = {"The least", "La menor"},
                                                            .role = PortRole::Output,
                                                            .unit = "m"},
                                             PortDescriptor{.name = "bearing",
                                                            .title = Text::same("bearing"),
                                                            .help = Text::same("bearing"),
                                                            .role = PortRole::Output,
                                                            .unit = "rad",
                                                            .type = ValueType::Circular}};
inline constexpr std::array kTargetParameters = {parameter<TargetConfig, &TargetConfig::at_m>(
    {.name = "at_m", .title = Text::same("at_m"), .help = Text::same("at_m"), .unit = "m", .count = 2})};
inline constexpr std::array kBackPorts = {PortDescriptor{.name = "left",
                                                         .title = Text::same("left"),
                                                         .help = {"Range on the left", "Distancia a la izquierda"},
                                                         .unit = "m"},
                                          PortDescriptor{.name = "right",
                                                         .title = Text::same("right"),
                                                         .help = {"Range on the right", "Distancia a la derecha"},
                                                         .unit = "m"},
                                          PortDescriptor{.name = "heading",
                                                         .title = Text::same("heading"),
                                                         .help = Text::same("heading"),
                                                         .unit = "rad",
                                                         .type = ValueType::Circular,
                                                         .required = false},
                                          PortDescriptor{.name = "drive",
                                                         .title = Text::same("drive"),
                                                         .help = Text::same("drive"),
                                                         .role = PortRole::Command,
                                                         .elements = kTracks}};
inline constexpr std::array kBackParameters = {
    parameter<BackConfig, &BackConfig::trigger_range_m>(
        {.name = "trigger_range_m",
         .title = {"trigger range", "distancia de disparo"},
         .help = {"Backs off nearer than this", "Retrocede si hay algo más cerca"},
         .unit = "m",
         .min = 0,
         .max = 3,
         .ours = true}),
    parameter<BackConfig, &BackConfig::side>(
        {.name = "side", .title = Text::same("side"), .help = Text::same("side"), .choices = kSides}),
    parameter<BackConfig, &BackConfig::bursts>(
        {.name = "bursts", .title = Text::same("bursts"), .help = Text::same("bursts"), .min = 1, .max = 10}),
    testing::named<BackConfig, &BackConfig::loud>("loud"), testing::named<BackConfig, &BackConfig::label>("label")};
inline constexpr std::array kGoToPorts = {PortDescriptor{.name = "request",
                                                         .title = Text::same("request"),
                                                         .help = Text::same("request"),
                                                         .role = PortRole::Request,
                                                         .unit = "m",
                                                         .elements = kPlane},
                                          PortDescriptor{.name = "position",
                                                         .title = Text::same("position"),
                                                         .help = Text::same("position"),
                                                         .unit = "m",
                                                         .elements = kPlane},
                                          testing::optional(testing::port("expected", PortRole::Appraisal, "m")),
                                          PortDescriptor{.name = "drive",
                                                         .title = Text::same("drive"),
                                                         .help = Text::same("drive"),
                                                         .role = PortRole::Command,
                                                         .elements = kTracks}};
inline constexpr std::array kFirstPorts = {testing::many(testing::port("commands", PortRole::Candidate, "*", 0)),
                                           testing::port("command", PortRole::Command, "*", 0)};

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

inline Description robot() {
  Description robot;
  robot.name = "Example";
  robot.sensations = {{"sonar_left.range", "m"},
                      {"sonar_right.range", "m"},
                      {"compass.heading", "rad", ValueType::Circular},
                      {"odometry.position", "m", ValueType::Real, {"x", "y"}}};
  robot.commands = {{"drive", {{"left"}, {"right"}}}, {"arm", {{"lift"}}}};
  return robot;
}

}  // namespace ganglion::example
