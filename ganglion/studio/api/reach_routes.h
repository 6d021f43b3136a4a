#pragma once

#include "ganglion/studio/api/current_run.h"
#include "ganglion/studio/api/router.h"

namespace ganglion::studio {

/// The commands that reach into the world of the run that is on. The run must outlive the router.
void add_reach_routes(Router& router, CurrentRun& run);

}  // namespace ganglion::studio
