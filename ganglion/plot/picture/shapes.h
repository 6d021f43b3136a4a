#pragma once

#include <set>
#include <span>

#include "ganglion/plot/canvas/axes.h"
#include "ganglion/plot/canvas/legend.h"
#include "ganglion/plot/view/shapes.h"

namespace ganglion::plot {

Colour colour_of(Role role) noexcept;
/// The line of a role, in its colour and dash.
Pen pen_of(Role role, double width_px = 2) noexcept;

/// Shapes as they are shown, in their order, labels last; axes of equal scale in metres.
void draw_shapes(Canvas& canvas, const Axes& axes, std::span<const PlacedShape> shapes, Language language);
/// One row for each role and form among them, in the order of roles.
void add_shapes_to_legend(Legend& legend, std::span<const PlacedShape> shapes, Language language);

/// A cell or box of a class: its sign over what is there, in a box of `size` about `centre`.
void draw_sign(Canvas& canvas, Sign sign, Vector2 centre, double size_px, Role role, Colour ground);

/// The tracks of a form that get pictures: those of the application and of the first robots.
std::vector<const ExhibitTrack*> drawn_tracks(const RunView& run, std::string_view form);
/// "Learned map: robot0 pathfinder router, 120 s"
std::string exhibit_title(const RunView& run, const ExhibitTrack& track, Language language);
/// "field-robot0-router-map": of all tracks another.
std::string exhibit_id(const ExhibitTrack& track);
/// Name and unit of an axis, in that language.
std::string axis_name(const shown::Axis& axis, Language language);

}  // namespace ganglion::plot
