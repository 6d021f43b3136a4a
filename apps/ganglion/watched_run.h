#pragma once

#include <filesystem>
#include <memory>

#include "ganglion/run/run.h"
#include "ganglion/studio/server/server.h"

namespace ganglion {

/// A run of the command line that browsers may watch. They cannot change it.
class WatchedRun {
 public:
  /// Starts a server on the experiment's folder, prints its URL, and has `options` tell it of the run.
  static Result<std::unique_ptr<WatchedRun>> open(const std::filesystem::path& experiment, const Prepared& prepared,
                                                  RunOptions& options);
  /// Hands over what is still to be told, and the outcome.
  void conclude(const RunResult& result);
  /// People go on looking until ctrl-C.
  void serve_until_interrupted() const;

 private:
  WatchedRun(std::unique_ptr<studio::Server> server, studio::Json state)
      : server_(std::move(server)), state_(std::move(state)) {}
  void tell(std::string_view phase, double share);

  std::unique_ptr<studio::Server> server_;
  std::shared_ptr<studio::LiveFeed> feed_ = std::make_shared<studio::LiveFeed>();
  studio::Json state_;
  double told_s_ = 0;
};

}  // namespace ganglion
