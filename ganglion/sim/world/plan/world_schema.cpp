#include "ganglion/sim/world/plan/world_schema.h"

#include "ganglion/config/outline_schema.h"
#include "ganglion/sim/world/plan/plan.h"

namespace ganglion::sim {
namespace {

/// Every form a table may have, where what the reader asks next depends on what it found.
constexpr std::string_view kSample = R"(format = 1

[[mover]]
id = "disc_with_places"
radius_m = 0.1
places = [[0, 0], [1, 0]]
change_after_s = [1, 2]

[[mover]]
id = "box_with_places"
length_m = 0.1
width_m = 0.1
places = [[0, 0], [1, 0]]
change_after_s = [1, 2]

[[mover]]
id = "disc_with_path"
radius_m = 0.1
path = [[0, 0], [1, 0]]
speed_mps = 1

[[mover]]
id = "box_with_path"
length_m = 0.1
width_m = 0.1
path = [[0, 0], [1, 0]]
speed_mps = 1

[[mover]]
id = "disc_that_strolls"
radius_m = 0.1
x_m = 0
y_m = 0
area = [0, 0, 1, 1]
speed_mps = 1

[[mover]]
id = "box_that_strolls"
length_m = 0.1
width_m = 0.1
x_m = 0
y_m = 0
area = [0, 0, 1, 1]
speed_mps = 1

[[floor]]
points = [[0, 0], [1, 0], [0, 1]]

[[floor]]
x_m = 0
y_m = 0
radius_m = 1

[[floor]]
x_m = 0
y_m = 0
length_m = 1
width_m = 1
)";

}  // namespace

std::list<config::Outline> world_outlines() {
  std::list<config::Outline> samples;
  Problems problems;  // none of ours; what the empty tables lack is not told
  parse_plan(kSample, "sample", problems, &samples.emplace_back());
  return samples;
}

std::string world_schema() { return config::schema_text("Ganglion world", world_outlines()); }

}  // namespace ganglion::sim
