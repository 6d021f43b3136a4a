#pragma once

#include "ganglion/plot/view/run_view.h"
#include "ganglion/record/run_file.h"

namespace ganglion::plot {

/// What pictures and reports need of a recorded run. Never fails: topics that are missing stay empty, and messages that
/// cannot be understood are left out and counted in an event at the end.
///
/// Topics   /run, /scene, /movers, /log; /robot<i>/signals, /robot<i>/goals, /robot<i>/map/<component>,
///          /robot<i>/route/<component>.
/// Signals  truth.x_m, truth.y_m, truth.yaw_rad, truth.touching; for each coordinator <id>.active (-1 = none),
///          <id>.wanted.<candidate> (else <candidate>.active), <id>.share.<candidate>.
/// Maps     foxglove.Grid of one-byte fields: label (0 unexplored, 1 or 128 empty, 2 or 255 occupied), risk (255 = 1),
///          dynamic or static, inhibited. A cell of no label but some risk counts as empty.
RunView from_run_file(const RunFile& file);

}  // namespace ganglion::plot
