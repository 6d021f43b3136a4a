#pragma once

#include <memory>

#include "ganglion/link/controller/remote_application.h"
#include "ganglion/link/net/program.h"
#include "ganglion/run/run.h"

namespace ganglion {

/// The robots of one run: simulated in this program, or at the other end of a link.
class RunRobots {
 public:
  /// As the experiment says. Fails where the robots find no place or cannot be reached.
  static Result<RunRobots> make(const Prepared& prepared, const RunOptions& options);
  /// Simulated on that ground, from the given poses where there are any.
  static Result<RunRobots> simulate(const Prepared& prepared, std::shared_ptr<const sim::Ground> ground,
                                    const std::vector<Pose2>& starts);

  Application& application() const noexcept { return *application_; }
  /// Null where only the robots' own sensors tell of them.
  const sim::Witness* witness() const noexcept { return witness_; }
  /// Null where they are simulated here.
  link::RemoteApplication* remote() const noexcept { return remote_; }
  /// Null where they are not.
  sim::Simulation* simulation() const noexcept { return simulation_; }
  /// Whether they have a clock of their own.
  bool free_running() const noexcept { return free_running_; }

 private:
  static Result<RunRobots> reach(const Prepared& prepared, const RunOptions& options);

  std::unique_ptr<link::Program> program_;  // outlives the link to it
  std::unique_ptr<Application> application_;
  const sim::Witness* witness_ = nullptr;
  link::RemoteApplication* remote_ = nullptr;
  sim::Simulation* simulation_ = nullptr;
  bool free_running_ = false;
};

}  // namespace ganglion
