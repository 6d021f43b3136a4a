#pragma once

#include <string>

#include "ganglion/plot/view/run_view.h"

namespace ganglion::report {

/// The run as JSON for the player in the page: pure ASCII, without < > &, so that it can stand in a <script> element
/// whatever the names in it say. Rows are thinned evenly until all of it is about `max_bytes`; that keeps 120 s at
/// 10 Hz whole.
std::string player_data(const plot::RunView& run, std::size_t max_bytes = 700000);

}  // namespace ganglion::report
