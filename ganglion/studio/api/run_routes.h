#pragma once

#include <functional>

#include "ganglion/studio/api/current_run.h"
#include "ganglion/studio/api/router.h"
#include "ganglion/studio/api/wanted.h"

namespace ganglion::studio {

/// The commands that start, hold and end runs.
class RunRoutes {
 public:
  /// Folder, reader, run and this object must outlive the router's last call.
  RunRoutes(Router& router, const Folder& folder, const WantedReader& wanted, CurrentRun& run);

 private:
  Reply start(const Ask&);
  /// What takes a run that was begun; false: it is over.
  Reply command(const Ask&, const std::function<bool(RunSession&)>& what);
  Reply step(const Ask&);
  Reply reset(const Ask&);
  Reply set_pace(const Ask&);

  const Folder& folder_;
  const WantedReader& wanted_;
  CurrentRun& run_;
};

}  // namespace ganglion::studio
