#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ganglion/application/application.h"
#include "ganglion/module/component.h"
#include "ganglion/random/draws.h"

namespace ganglion {

/// Where a task is set: what can be known there, before anything runs.
struct TaskSetting {
  std::span<const TruthChannel> truth;
  const Terrain* terrain = nullptr;  ///< Null: there is no ground.
  std::optional<double> radius_m;    ///< Of the body's disc; none where there is no body.
};

/// One instant, as a task sees the robot or plant that it is set to.
struct Outlook {
  std::uint32_t tick = 0;
  double time_s = 0;
  std::span<const double> truth;     ///< In the order of the setting's channels.
  const Terrain* terrain = nullptr;  ///< With what moves on it.
};

/// Sets requests to a controller as sensations, hears what it makes of them, and judges what comes of it: the
/// application as trainer, "App" in the GFM papers. It sits beside the application, where the truth is.
class Task {
 public:
  Task() = default;
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;
  virtual ~Task() = default;

  /// Between what the finite values of the n-th channel lie; the kind's descriptor lists the channels as Output ports.
  struct Limits {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
  };
  virtual Limits limits(std::size_t channel) const noexcept {
    static_cast<void>(channel);
    return {};
  }
  /// What it keeps; `task` is left to whoever knows its id.
  virtual LedgerForm form() const { return {}; }

  /// Once, before the first episode. Fails with BadParameter or Unsupported where it cannot be set there.
  virtual Result<void> settle(const TaskSetting&) { return {}; }
  /// An episode begins. Fails with BadParameter where the application as it stands makes no sense to it.
  virtual Result<void> begin(const Outlook&, Draws) { return {}; }
  /// What the controller commands, and where it withdraws: before the application carries it out.
  virtual void hear(const ActFrame&) noexcept {}
  /// At the end of every step, before stop rules look and before the next frame is sensed; and once as the episode
  /// begins. Takes no memory.
  virtual void judge(const Outlook&) noexcept = 0;
  /// Its channels' values, one after the other.
  virtual void tell(const Outlook&, std::span<double> values) const noexcept = 0;
  /// Null where it keeps nothing.
  virtual const Ledger* ledger() const noexcept { return nullptr; }

  virtual std::span<const InterventionDescriptor> interventions() const noexcept { return {}; }
  /// One of them, its arguments in the descriptor's order. See Application::intervene().
  virtual Result<Intervened> intervene(const Outlook&, const InterventionDescriptor& what,
                                       std::span<const double> arguments) {
    static_cast<void>(what), static_cast<void>(arguments);
    return fail(ErrorCode::Unsupported, {"this task takes no interventions", "esta tarea no admite intervenciones"});
  }
};

/// See ganglion/task/<kind>/.
using TaskKind = Kind<Task>;

}  // namespace ganglion
