#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ganglion/application/description.h"
#include "ganglion/config/outline.h"
#include "ganglion/config/value.h"
#include "ganglion/descriptor/common_parameters.h"
#include "ganglion/descriptor/ports.h"
#include "ganglion/graph/kind_list.h"
#include "ganglion/module/tick/request.h"

namespace ganglion {

/// Where a wire comes from, once its text is understood.
struct Source {
  enum class Kind {
    Unresolved,     ///< Not understood; a problem was reported.
    Output,         ///< An output of a component: a percept or a signal.
    Sensation,      ///< The values of a sensation.
    SensationAge,   ///< The time since it was measured [s].
    RobotCommand,   ///< The last command frame; always of the tick before.
    ModuleCommand,  ///< The command of an acting module or coordinator, for a candidate or request port.
    Goal,           ///< The bids of a goal, for a request port.
  };
  std::string text;  ///< As written: "escape.active@previous".
  Place place{};
  Kind kind = Kind::Unresolved;
  int component = -1;  ///< Index into ControllerModel::components; of RobotCommand the channel.
  int port = -1;       ///< Of an Output: index among the component's outputs.
  int element = -1;    ///< One value of several; -1 = all of them.
  int size = 0;        ///< Number of values.
  bool previous = false;
};

struct Wire {
  int port = -1;  ///< Index into the descriptor's ports.
  std::vector<Source> sources;
  Place place{};
};

/// One output of a component as laid out for this controller: declared ones first, then those common to its class.
struct OutputShape {
  std::string name;
  std::string unit;
  ValueType type = ValueType::Real;
  std::vector<std::string> elements;  ///< Empty = one value.
  bool declared = true;
  bool derived = false;  ///< In no digest.
  Meaning meaning = Meaning::None;
  int size() const noexcept { return elements.empty() ? 1 : static_cast<int>(elements.size()); }
};

/// One box of the drawing.
struct ComponentModel {
  std::string id;
  ComponentClass component_class = ComponentClass::Sensation;
  const Descriptor* descriptor = nullptr;  ///< Null for sensations.
  Parameters parameters{{}};
  Parameters common{{}};                ///< Those of its class.
  std::shared_ptr<const Ports> shaped;  ///< Where its parameters shape its ports.
  Place place{};
  std::string channel;  ///< Of a sensation: the robot's channel.
  Place channel_place{};
  int channel_index = -1;
  std::vector<Wire> wires;
  std::string command;  ///< Of an acting module or coordinator: the robot's command it drives, "" = none.
  Place command_place{};
  int command_index = -1;
  Comparison comparison{};  ///< Of an acting module: of its first Feedback port with what is sought.
  std::vector<OutputShape> outputs;

  /// Its ports, as its parameters shape them. None of a sensation.
  std::span<const PortDescriptor> ports() const noexcept {
    if (shaped != nullptr) return shaped->list();
    return descriptor != nullptr ? descriptor->ports : std::span<const PortDescriptor>{};
  }
  /// The port of that name, or the first of that role; null if there is none.
  const PortDescriptor* port(std::string_view name) const noexcept;
  const PortDescriptor* port_of(PortRole role) const noexcept;
  const Wire* wire(int port) const noexcept;
};

/// A controller as its file says it, checked against the kinds and, by resolve(), against a robot.
struct ControllerModel {
  std::string name;
  std::filesystem::path robot;  ///< The robot description it was drawn for.
  double tick_s = 0;            ///< The step it was made for; 0 = the application's.
  std::vector<ComponentModel> components;
  /// Ids of components that could not be understood at all: what names them is not reported on top of that. An empty
  /// one stands for a component whose id is missing: any name may mean it.
  std::vector<std::string> misread;

  int find(std::string_view id) const noexcept;
};

/// Most components a controller may have.
inline constexpr std::size_t kMaxComponents = 4096;
/// Most wires one input may take, and most values that all signals and inputs together may have.
inline constexpr std::size_t kMaxWires = 4096;
inline constexpr std::size_t kMaxValues = std::size_t{1} << 20;
/// Most bytes that the files named by its parameters may have together, one that is named twice counted twice.
inline constexpr std::size_t kMaxFileTexts = std::size_t{64} << 20;

/// The tolerance of an element of a Feedback port that requests are compared with, where the file gives none: 0.05 m,
/// 5 deg, and 0 for whole numbers, whose requests take no other, and for every other unit.
double default_tolerance(const PortDescriptor& port, std::size_t element) noexcept;

/// Reads a controller file. Every problem is reported at its place; the model holds what was understood. `files` opens
/// what parameters name, without it they may name nothing; `outline` takes down what was asked.
ControllerModel read_controller(const config::Value& root, const KindList& kinds, Problems& problems,
                                FileReader* files = nullptr, config::Outline* outline = nullptr);

/// Understands every wire against the robot: dangling ends, shapes, units, second writers, commands that go nowhere.
void resolve(ControllerModel& model, const Description& robot, Problems& problems);

}  // namespace ganglion
