#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ganglion/application/application.h"
#include "ganglion/graph/digest.h"
#include "ganglion/graph/model.h"
#include "ganglion/graph/order.h"
#include "ganglion/graph/part.h"

namespace ganglion {

/// One value that can be recorded, plotted and watched.
struct Signal {
  std::string name;  ///< "sonar_left", "position.x", "escape.active", "drive.left"
  std::string unit;
  Meaning meaning = Meaning::None;
};

/// What one component has learned.
struct ModuleExperience {
  std::string component;
  std::string kind;
  std::uint32_t version = 0;
  std::vector<ExperiencePart> parts;
  std::vector<RestsOn> rests_on{};  ///< Empty: nothing, or nobody wrote it down.
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
  static Result<Controller> compile(const ControllerModel& model, const Description& robot, const KindList& kinds,
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

  /// The components that learn, and all that they have learned, as it is stored. Between ticks.
  std::vector<LearningComponent> learners() const;
  std::vector<ModuleExperience> experience() const;
  /// Hands what was learned to the components it came from; what no component claims, or was learned with other values
  /// of what it rests on, is reported and left alone.
  void load(const std::vector<ModuleExperience>& learned, Problems& problems);

  /// How many requests to acting modules were satisfied or withdrawn so far: then something may have been learned.
  std::uint64_t concluded() const noexcept;

  int components() const noexcept { return static_cast<int>(parts_.size()); }
  const std::string& id(int component) const noexcept { return parts_[static_cast<std::size_t>(component)].id; }
  /// For exhibits; null for sensations.
  const Component* component(int index) const noexcept {
    return parts_[static_cast<std::size_t>(index)].component.get();
  }
  /// Null for components of other classes.
  const ActingModule* acting(int index) const noexcept;
  /// The request of an acting module; null for behaviours and other components.
  const RequestSlot* request(int index) const noexcept;

 private:
  friend class Compiler;

  Controller() : block_(std::make_unique<layout::Block>()) {}
  void sense(const SenseFrame& frame) noexcept;
  void run_sensing(const Tick& tick) noexcept;
  void settle(std::optional<double> cost) noexcept;
  void run_goals(const Tick& tick) noexcept;
  void run_acting(const Tick& tick) noexcept;
  void coordinate(layout::Part& part, const Tick& tick) noexcept;
  static CommandOrigin write(const layout::ChannelOut& channel, const Command& command,
                             std::span<double> values) noexcept;
  void grant() noexcept;
  void send(ActFrame& act, double step_s) noexcept;
  void close(const Tick& tick) noexcept;
  void gather(const layout::Part& part) noexcept;
  void publish(const layout::Part& part) noexcept;
  void publish_goal(const layout::Part& part, const Tick& tick) noexcept;
  void publish_acting(const layout::Part& part) noexcept;
  void publish_shares(const layout::Part& part) noexcept;
  void set_ages(const layout::Part& part, double age_s) noexcept;
  layout::Part& part(int index) noexcept { return parts_[static_cast<std::size_t>(index)]; }
  const layout::Part& part(int index) const noexcept { return parts_[static_cast<std::size_t>(index)]; }

  std::unique_ptr<layout::Block> block_;
  std::vector<layout::Part> parts_;
  std::vector<Signal> signals_;
  std::vector<layout::ChannelOut> channels_;
  layout::Stretch command_frame_;
  std::size_t sense_values_ = 0, sense_channels_ = 0;
  Schedule schedule_;
  std::vector<int> sensations_,
      asked_by_goals_;  // of the parts; side by side, so that a tick need not look at all of them
  Digest digest_;
  std::vector<layout::Digested> digested_;
};

}  // namespace ganglion
