#pragma once

#include <nlohmann/json.hpp>

#include "ganglion/plot/view/run_view.h"

namespace ganglion::report {

/// A style element with the colour of each role as --role-NAME, for light and dark pages.
std::string roles_style();

/// What was shown during the run, as the player takes it: fields as states of which each changes the one before, shapes
/// with the time they were there, everything else as it changed.
nlohmann::json exhibits_json(const plot::RunView& run);

/// Columns of the robot's signals that exhibits depend on: frames, radii, cursors. At most 200.
std::vector<std::string> columns_needed(const plot::RunView& run, int robot);

}  // namespace ganglion::report
