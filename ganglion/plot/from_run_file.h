#pragma once

#include "ganglion/plot/view/run_view.h"
#include "ganglion/record/run_file.h"

namespace ganglion::plot {

/// What pictures and reports need of a recorded run. Never fails: topics that are missing stay empty, and messages that
/// cannot be understood are left out and counted in an event at the end.
///
/// Topics   /run, /scene, /movers, /log; /robot<i>/signals, and what was shown (ganglion/record/exhibit/track.h); of files
///          of before what they had instead (old_run_file.h).
/// Signals  truth.x_m, truth.y_m, truth.yaw_rad, truth.touching; for each coordinator <id>.active (-1 = none),
///          <id>.wanted.<candidate> (else <candidate>.active), <id>.share.<candidate>.
RunView from_run_file(const RunFile& file);

/// What was shown during a run, in the order of its topics; of files of before, which knew maps, routes and goals by
/// name, these as exhibits. Adds what cannot be understood to `unread`.
std::vector<ExhibitTrack> exhibits_of(const RunFile& file, std::size_t& unread);

}  // namespace ganglion::plot
