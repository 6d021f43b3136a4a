#pragma once

#include "ganglion/plot/view/run_view.h"

namespace ganglion::plot {

/// A made-up run of 6 x 5 m with walls, furniture and a mover: robots that go round by three behaviours (escape, avoid,
/// navigate), two sonars each with lost echoes (NaN), empty ranges (+inf) and readings too close (-inf).
RunView sample_behaviour_run(int robots, double duration_s);

/// A made-up run of one robot with a router: goals reached and withdrawn, routes, a map that grows with risk,
/// inhibitions and failed attempts, a mover that jumps between two places.
RunView sample_router_run();

/// A made-up run of one robot with a component that shows something of every form (ShowsAll).
RunView sample_exhibits_run();

/// A run that ended before its first tick.
RunView empty_run();

/// Every number that may be missing is.
RunView unreadable_run();

}  // namespace ganglion::plot
