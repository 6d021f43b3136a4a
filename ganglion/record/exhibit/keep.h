#pragma once

#include <optional>

#include "ganglion/record/exhibit/shown.h"

namespace ganglion::shown {

// What is shown, with contents of its own. What cannot be drawn is left out: points that are not finite, shapes without
// points, bars without a value; none where nothing is left that says what was meant (a field whose layers are of another
// size than it says, a scale that does not rise).
std::optional<Exhibit> keep(const FrameExhibit& frame);
std::optional<Exhibit> keep(const FieldExhibit& field);
std::optional<Exhibit> keep(const CurveExhibit& curve);
std::optional<Exhibit> keep(const BarExhibit& bars);
std::optional<Exhibit> keep(const MarkExhibit& marks);
std::optional<Exhibit> keep(const NetworkExhibit& network);

}  // namespace ganglion::shown
