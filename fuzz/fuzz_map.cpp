// Maps of ROS. The first byte of an input chooses: a PGM image, a YAML file, or both in one input, the YAML first,
// parted by a zero byte.
#include <vector>

#include "fuzz/target.h"
#include "ganglion/sim/world/ground.h"
#include "ganglion/sim/world/map/flat_yaml.h"
#include "ganglion/sim/world/map/grey_image.h"
#include "ganglion/sim/world/map/occupancy_map.h"

namespace ganglion::fuzz {
namespace {

constexpr std::size_t kMaxPixels = 1 << 16;

void read_image(std::string_view bytes) {
  const auto image = sim::parse_pgm(bytes, "a.pgm", kMaxPixels);
  if (!image) return;
  must(image->values.size() == static_cast<std::size_t>(image->columns) * image->rows, "every pixel is there");
#ifdef GANGLION_PLANTED_BUG
  std::vector<int> shades(256);  // "grey images have eight bits"
#else
  std::vector<int> shades(static_cast<std::size_t>(image->max_value) + 1);
#endif
  for (const std::uint16_t value : image->values) ++shades.data()[value];
}

void read_map(std::string_view input) {
  const std::size_t end = std::min(input.find('\0'), input.size());
  const auto yaml = put("map.yaml", input.substr(0, end));
  put("map.pgm", input.substr(std::min(end + 1, input.size())));
  Problems problems;
  const auto map = sim::OccupancyMap::load(yaml, problems);
  must(map.has_value() == problems.empty(), "a map is refused with a reason, and only then");
  if (!map) return;
  const auto counts = map->counts();
  must(counts[0] + counts[1] + counts[2] == static_cast<std::size_t>(map->columns()) * map->rows(),
       "every cell counts");
  static_cast<void>(map->at(map->corner(map->columns() / 2, map->rows() / 2)));
  Problems of_ground;
  const auto ground = sim::Ground::load(yaml, of_ground);
  if (!ground) return;
  const Box2 box = ground->bounds();
  const Vector2 middle = (box.lower + box.upper) * 0.5;
  static_cast<void>(ground->cast(middle, {1, 0}, 3));
  static_cast<void>(ground->clearance(middle, 1));
}

}  // namespace

void run_input(std::string_view input) {
  switch (choice(input, 3)) {
    case 0:
      read_image(input);
      break;
    case 1:
      static_cast<void>(sim::parse_flat_yaml(input, "a.yaml"));
      break;
    default:
      read_map(input);
  }
}

}  // namespace ganglion::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ganglion::fuzz::run_input({reinterpret_cast<const char*>(data), size});
  return 0;
}
