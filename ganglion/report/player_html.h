#pragma once

#include <string>

#include "ganglion/plot/view/run_view.h"
#include "ganglion/report/words.h"

namespace ganglion::report {

/// The player's canvas, buttons, switches, legend and data. What a run does not have is not offered.
std::string player_section(const plot::RunView& run, plot::Language language);

}  // namespace ganglion::report
