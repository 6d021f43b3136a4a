#pragma once

#include <memory>

#include "ganglion/link/controller/remote_application.h"
#include "ganglion/link/net/program.h"
#include "ganglion/run/run.h"

namespace ganglion {

/// The application of one run: in this program, or at the other end of a link.
class RunRobots {
 public:
  /// As the experiment says. Fails where the robots find no place or cannot be reached.
  static Result<RunRobots> make(const Prepared& prepared, const RunOptions& options);
  /// In this program.
  static Result<RunRobots> make_here(std::unique_ptr<Application> application);

  Application& application() const noexcept { return *application_; }
  /// Null where only the robots' own sensors tell of them.
  const Witness* witness() const noexcept { return application_->witness(); }
  /// Null where it runs here.
  link::RemoteApplication* remote() const noexcept { return remote_; }
  /// Null where it does not.
  Application* here() const noexcept { return remote_ == nullptr ? application_.get() : nullptr; }
  /// What their program prints lies beside that run file from now on.
  void name_output(const std::filesystem::path& run_file);
  /// Whether they have a clock of their own.
  bool free_running() const noexcept { return free_running_; }

 private:
  static Result<RunRobots> reach(const Prepared& prepared, const RunOptions& options);

  std::unique_ptr<link::Program> program_;  // outlives the link to it
  std::unique_ptr<Application> application_;
  link::RemoteApplication* remote_ = nullptr;
  bool free_running_ = false;
};

}  // namespace ganglion
