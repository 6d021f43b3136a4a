#pragma once

#include <memory>

#include "ganglion/lab/carry_out.h"

namespace ganglion {

/// A run of the command line that browsers may watch. They cannot change it.
class WatchedRun {
 public:
  /// Starts a server on the experiment's folder, prints its URL, and has `hooks` tell it of the run and its outcome.
  /// Fails with Unsupported in a program that was built without the studio.
  static Result<std::unique_ptr<WatchedRun>> open(const Prepared& prepared, const lab::Job& job, lab::Hooks& hooks);
  virtual ~WatchedRun() = default;
  /// People go on looking until ctrl-C.
  virtual void serve_until_interrupted() const = 0;
};

}  // namespace ganglion
