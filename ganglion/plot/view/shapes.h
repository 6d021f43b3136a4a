#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "ganglion/plot/view/run_view.h"

namespace ganglion::plot {

/// A shape that was shown, and where: all that depends on recorded columns is worked out.
struct PlacedShape {
  const shown::Shape* shape = nullptr;
  Pose2 frame{};        ///< Of its points, in the world.
  double radius_m = 0;  ///< As its signal says, where one does; 0 where that has no reading.
};

/// What a column of a robot's signals says; "robot1/truth.x_m" is another robot's. NaN where there is none.
double column_at(const RunView& run, int robot, std::string_view column, double time_s);

/// Where a frame is in the world; none where it does not lead there, or a column that leads it has no reading.
std::optional<Pose2> frame_at(const RunView& run, const ExhibitOwner& owner, std::string_view frame, double time_s);

/// The shapes that are shown in the world at a time.
std::vector<PlacedShape> shapes_at(const RunView& run, double time_s);

/// Those at the end of the run, and of roles that last all there ever were, each as it was last.
std::vector<PlacedShape> lasting_shapes(const RunView& run);

}  // namespace ganglion::plot
