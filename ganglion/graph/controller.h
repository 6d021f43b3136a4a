#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ganglion/application/application.h"
#include "ganglion/graph/digest.h"
#include "ganglion/graph/goal_arbiter.h"
#include "ganglion/graph/model.h"
#include "ganglion/graph/order.h"

namespace ganglion {

/// One value that can be recorded, plotted and watched.
struct Signal {
  std::string name;  ///< "sonar_left", "position.x", "escape.active", "drive.left"
  std::string unit;
};

/// What one component has learned.
struct ModuleExperience {
  std::string component;
  std::string kind;
  std::uint32_t version = 0;
  std::vector<ExperiencePart> parts;
};

/// Which run and robot a controller lives in: the sources of chance depend on nothing else.
struct Identity {
  std::uint64_t seed = 0;
  std::uint32_t episode = 0;
  std::uint32_t robot = 0;
};

/// A compiled controller: a flat schedule over one block of values. A tick allocates nothing, locks nothing and cannot
/// fail.
class Controller {
 public:
  /// Compiles a model that read_controller() and resolve() found without problems. Fails where a kind refuses its
  /// parameters or wires run in a circle.
  static Result<Controller> compile(const ControllerModel& model, const RobotDescription& robot, const KindList& kinds,
                                    const Identity& identity);
  Controller(Controller&&) noexcept = default;
  Controller& operator=(Controller&&) noexcept = default;

  /// One frame in, one frame out (design of the tick: docs/architecture.md).
  void tick(const SenseFrame& sense, double step_s, ActFrame& act) noexcept;
  /// Between ticks: modules that grow take memory now.
  void grow();

  /// The recorded values and their names, in the same order.
  const std::vector<Signal>& signals() const noexcept { return signals_; }
  std::span<const double> values() const noexcept { return {block_->now.data(), signals_.size()}; }
  const Digest& digest() const noexcept { return digest_; }

  std::vector<ModuleExperience> experience() const;
  /// Hands what was learned to the components it came from; what no component claims is reported and left alone.
  void load(const std::vector<ModuleExperience>& learned, Problems& problems);

  int components() const noexcept { return static_cast<int>(parts_.size()); }
  const std::string& id(int component) const noexcept { return parts_[static_cast<std::size_t>(component)].id; }
  /// For exhibits; null for sensations.
  const Component* component(int index) const noexcept;
  const ActingModule* acting(int index) const noexcept { return parts_[static_cast<std::size_t>(index)].acting.get(); }
  /// The request of an acting module; null for behaviours and other components.
  const RequestSlot* request(int index) const noexcept { return parts_[static_cast<std::size_t>(index)].request.get(); }

 private:
  friend class Compiler;

  /// Values lie at fixed addresses for a controller's whole life: spans point into them.
  struct Block {
    std::vector<double> now, before;        ///< Signals first, then one stretch for each input port.
    std::vector<double> ages, ages_before;  ///< For each signal stretch, then for each wire of each input.
  };
  struct Copy {
    std::size_t to, from, count;
    std::size_t age_to, age_from;
    bool previous;
  };
  struct Stretch {
    std::size_t first = 0, count = 0;
  };
  struct Part {
    std::string id;
    std::string kind;
    ComponentClass component_class = ComponentClass::Sensation;
    std::unique_ptr<SensingModule> sensing;
    std::unique_ptr<GlobalGoal> goal;
    std::unique_ptr<ActingModule> acting;
    std::unique_ptr<Coordinator> coordinator;
    std::unique_ptr<RequestSlot> request;
    RequestSlot* below = nullptr;  ///< Of a coordinator whose command is a request.
    std::optional<GoalArbiter> arbiter;
    std::vector<Copy> gather;          ///< Wires to copy before it runs.
    Stretch signals;                   ///< All its outputs.
    Stretch out_ages;                  ///< One age for each output.
    std::vector<std::size_t> aged_by;  ///< Of a sensing module: ages of the readings its percepts are made of.
    std::size_t common = 0;            ///< First of the outputs common to the class.
    Stretch command_signals;           ///< Of acting modules and coordinators: their command's values.
    std::vector<PortView> views;
    std::vector<std::span<double>> outputs;
    std::vector<const Command*> candidates;
    std::vector<int> candidate_parts;
    std::vector<double> shares;
    int charged_by = -1;  ///< The module whose cost is its cost, behind coordinators; -1 = the application's.
    Command command{};    ///< Of a coordinator.
    bool granted = true;
    std::size_t frame_offset = 0, channel = 0;  ///< Of a sensation.
    std::size_t digest = 0;
  };
  struct ChannelOut {
    int writer = -1;
    std::size_t offset = 0;
    std::vector<CommandElement> elements;
  };

  Controller() : block_(std::make_unique<Block>()) {}
  void sense(const SenseFrame& frame) noexcept;
  void run_sensing(const Tick& tick) noexcept;
  void run_goals(const Tick& tick) noexcept;
  void run_acting(const Tick& tick) noexcept;
  void coordinate(Part& part, const Tick& tick) noexcept;
  static CommandOrigin write(const ChannelOut& channel, const Command& command, std::span<double> values) noexcept;
  void grant() noexcept;
  void send(ActFrame& act, double step_s) noexcept;
  void close(const Tick& tick) noexcept;
  void gather(Part& part) noexcept;
  void publish(Part& part) noexcept;
  void set_ages(const Part& part, double age_s) noexcept;
  const Command& command_of(const Part& part) const noexcept;

  std::unique_ptr<Block> block_;
  std::vector<Part> parts_;
  std::vector<Signal> signals_;
  std::vector<ChannelOut> channels_;
  Stretch command_frame_;
  std::size_t sense_values_ = 0, sense_channels_ = 0;
  Schedule schedule_;
  Digest digest_;
  std::size_t command_digest_ = 0;
};

}  // namespace ganglion
