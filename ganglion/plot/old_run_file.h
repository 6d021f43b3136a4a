#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "ganglion/record/exhibit/track.h"
#include "ganglion/record/run_file.h"

namespace ganglion::plot {

/// What run files of before told by name, as exhibits. This is the only place that still knows those names.
///
/// /robot<i>/map/<component>    foxglove.Grid of one-byte fields: label (0 unexplored, 1 or 128 empty, 2 or 255
///                              occupied), risk (255 = 1), dynamic or static, inhibited. A cell of no label but some risk
///                              counts as empty. A cell inhibited anew means a try that failed since the message before,
///                              made from where the robot came nearest to the cell in that time.
/// /robot<i>/route/<component>  points of the route that was planned.
/// /robot<i>/goals              goals of a trainer, and what became of them.
std::vector<ExhibitTrack> old_exhibits(const RunFile& file, std::size_t& unread);

/// The map of one foxglove.Grid; none if its layers do not fit its size, or are too large.
std::optional<shown::Field> old_map(const nlohmann::json& grid);

}  // namespace ganglion::plot
