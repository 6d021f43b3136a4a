#pragma once

#include <vector>

#include "ganglion/plot/canvas/picture.h"
#include "ganglion/plot/picture/words.h"
#include "ganglion/plot/view/run_view.h"

namespace ganglion::plot {

/// How wide pictures are; their heights follow from what they show.
inline constexpr double kPictureWidth_px = 960;

// Each picture keeps a pointer to the run, which must outlive it.

/// The way of every robot over the ground: coloured by the behaviour that drove, or green arrows where no coordinator
/// decided; start, end, contacts, goals and failed attempts as in figure 7 of the GFM paper.
Picture trajectory_picture(const RunView& run, Language language);

/// The learned maps at the end of the run, one picture each; none where nothing was learned.
std::vector<Picture> learned_map_pictures(const RunView& run, Language language);

/// Every signal of a robot against time as small multiples, at most 60 panels a picture.
std::vector<Picture> signal_pictures(const RunView& run, Language language);

/// Who drove, who wanted to, who was quiet: one picture per robot that has coordinators.
std::vector<Picture> behaviour_pictures(const RunView& run, Language language);

/// Robots whose maps, signals and behaviours get pictures of their own; further ones are in the run file.
inline constexpr std::size_t kMaxDrawnRobots = 4;

/// All of the above in this order.
std::vector<Picture> all_pictures(const RunView& run, Language language);

}  // namespace ganglion::plot
