#pragma once

#include <vector>

#include "ganglion/plot/canvas/canvas.h"
#include "ganglion/plot/picture/fields/cells.h"
#include "ganglion/plot/view/run_view.h"

namespace ganglion::plot {

/// One layer of a field painted: a continuous one by its scale with a bar beside it, one of classes in their colours.
struct Panel {
  const shown::Field* field = nullptr;
  std::size_t layer = 0;
  std::vector<std::size_t> signs;  ///< Layers of classes whose signs stand over it.
};

/// Which layers are painted, a panel each: the continuous ones, with all others as signs; else those of classes.
std::vector<Panel> panels_of(const shown::Field& field);

/// Axes for a field that fit into `room_px`: in the world of equal scale, of others its own.
Axes field_axes(const shown::Field& field, const Cells& cells, Vector2 corner_px, Vector2 room_px);

inline constexpr double kScaleBar_px = 84;  ///< Room to the right of a panel.

/// The panel with its frame, ticks, name and scale; `scene` drawn over it where the field lies in the world.
void draw_panel(Canvas& canvas, const Axes& axes, const Panel& panel, const Cells& cells, const Scene* scene,
                Language language);

}  // namespace ganglion::plot
