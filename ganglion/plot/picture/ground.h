#pragma once

#include "ganglion/plot/canvas/axes.h"
#include "ganglion/plot/canvas/legend.h"
#include "ganglion/plot/picture/words.h"
#include "ganglion/plot/view/run_view.h"

namespace ganglion::plot {

/// The floor, walls, furniture and movers of a scene as they are at `time_s`; the other places of movers dashed.
void draw_ground(Canvas& canvas, const Axes& axes, const Scene& scene, double time_s);

/// The signs that draw_ground() used, and no others.
void add_ground_to_legend(Legend& legend, const Scene& scene, const Words& words);

/// A bar of round length beside its length in metres, `corner` at its left end.
void draw_scale_bar(Canvas& canvas, Vector2 corner, double pixels_per_m, double room_px);

/// Width of the longer of a word's two languages: a layout by it is the same in both.
double widest(Canvas& canvas, WordOf word, const TextStyle& style = {});

}  // namespace ganglion::plot
