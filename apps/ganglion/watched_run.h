#pragma once

#include <filesystem>
#include <memory>

#include "ganglion/run/run.h"

namespace ganglion {

/// A run of the command line that browsers may watch. They cannot change it.
class WatchedRun {
 public:
  /// Starts a server on the experiment's folder, prints its URL, and has `options` tell it of the run. Fails with
  /// Unsupported in a program that was built without the studio.
  static Result<std::unique_ptr<WatchedRun>> open(const std::filesystem::path& experiment, const Prepared& prepared,
                                                  RunOptions& options);
  virtual ~WatchedRun() = default;
  /// Hands over what is still to be told, and the outcome.
  virtual void conclude(const RunResult& result) = 0;
  /// People go on looking until ctrl-C.
  virtual void serve_until_interrupted() const = 0;
};

}  // namespace ganglion
