#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ganglion/application/description.h"
#include "ganglion/graph/goal_arbiter.h"
#include "ganglion/module/acting_module.h"
#include "ganglion/module/coordinator.h"
#include "ganglion/module/sensing_module.h"

/// How a compiled controller lies in memory: one block of values, and for each component where it reads and writes.
namespace ganglion::layout {

/// Values lie at fixed addresses for a controller's whole life: spans point into them.
struct Block {
  std::vector<double> now, before;        ///< Signals first, then one stretch for each input port.
  std::vector<double> ages, ages_before;  ///< For each output, then for each wire of each input.
};

struct Stretch {
  std::size_t first = 0, count = 0;
};

/// A wire, copied before its component runs.
struct Copy {
  std::size_t to, from, count;
  std::size_t age_to, age_from;
  bool previous;
};

struct SensationRole {
  std::size_t frame_offset = 0, channel = 0;
};

struct SensingRole {
  SensingModule* module;
  std::vector<std::size_t> aged_by{};  ///< Ages of the readings its percepts are made of.
};

struct GoalRole {
  GlobalGoal* goal;
  /// The acting modules it asks, and which of their goals it is.
  std::vector<std::pair<int, std::size_t>> asks{};
};

struct ActingRole {
  ActingModule* module;
  std::unique_ptr<RequestSlot> request{};
  std::optional<GoalArbiter> arbiter{};
  std::vector<ReasonCode> likes{};  ///< Of its kind's own reasons.
  RequestSlot* below = nullptr;     ///< Where its commands become requests.
  int charged_by = -1;              ///< The module whose cost is its cost, behind coordinators; -1 = the application's.
};

struct CoordinatorRole {
  Coordinator* coordinator;
  std::vector<const Command*> candidates{};
  std::vector<int> candidate_parts{};
  std::vector<double> shares{};
  RequestSlot* below = nullptr;  ///< Where its command is a request.
  Command command{};
};

/// One component of a controller.
struct Part {
  std::string id;
  std::string kind;                      ///< "" of a sensation.
  std::unique_ptr<Component> component;  ///< Null of a sensation; its role knows it by its class.
  Encode encode = nullptr;               ///< Of what it learns.
  std::vector<RestsOn> rests_on{};
  std::variant<SensationRole, SensingRole, GoalRole, ActingRole, CoordinatorRole> role;
  std::vector<Copy> gather{};
  Stretch signals{};                      ///< All its outputs and its command.
  std::size_t digested = 0;               ///< So many of them, the first, are in the digest.
  Stretch out_ages{};                     ///< One age for each output.
  std::vector<std::size_t> outputs_at{};  ///< The first value of each output.
  std::vector<std::size_t> common_at{};   ///< The same of those common to its class, in their order.
  Stretch command_signals{};              ///< Of acting modules and coordinators: their command's values.
  std::vector<PortView> views{};
  std::vector<std::span<double>> outputs{};
  double share = 1;  ///< What part of its last command was carried out.

  template <class Role>
  Role* as() noexcept {
    return std::get_if<Role>(&role);
  }
  template <class Role>
  const Role* as() const noexcept {
    return std::get_if<Role>(&role);
  }
};

/// What takes part in the digest, and as which of its components.
struct Digested {
  std::size_t component = 0;
  Stretch values;
};

/// A command of the robot, and who writes it.
struct ChannelOut {
  int writer = -1;
  std::size_t offset = 0;
  std::vector<CommandElement> elements;
  std::vector<std::size_t> from;  ///< Of each element the value of the command that is meant for it.
};

}  // namespace ganglion::layout
