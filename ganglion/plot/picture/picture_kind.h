#pragma once

#include <vector>

#include "ganglion/descriptor/descriptor.h"
#include "ganglion/plot/canvas/picture.h"
#include "ganglion/plot/view/run_view.h"

namespace ganglion::plot {

/// A kind of picture: what it says of itself, when there is something for it, and how it is drawn.
struct PictureKind {
  Descriptor descriptor;
  int order = 0;  ///< Among the pictures of a run: the lowest first, then by name.
  bool (*wants)(const RunView& run) = nullptr;
  /// One picture or several (a robot each, pages); each keeps a pointer to the run, which must outlive it. Their size is
  /// known before there is anything to draw on, and each can be drawn in any format.
  std::vector<Picture> (*draw)(const RunView& run, Language language) = nullptr;
};

/// How wide pictures are; their heights follow from what they show.
inline constexpr double kPictureWidth_px = 960;
/// Robots whose exhibits, signals and behaviours get pictures of their own; further ones are in the run file.
inline constexpr std::size_t kMaxDrawnRobots = 4;

}  // namespace ganglion::plot
