#pragma once

#include <string>

#include "ganglion/plot/view/run_view.h"
#include "ganglion/report/words.h"

namespace ganglion::report {

/// Whether there is anything to watch: something that stands somewhere, an exhibit, or behaviours to choose from. A plant that
/// shows nothing has its signals and figures alone.
bool can_be_watched(const plot::RunView& run);

/// The player's canvas, buttons, switches, legend and data. What a run does not have is not offered.
std::string player_section(const plot::RunView& run, plot::Language language);

}  // namespace ganglion::report
