#include "ganglion/module/testing/allocations.h"
#include "ganglion/sim/simulation/testing/trial.h"

namespace ganglion::sim {
namespace {

constexpr std::string_view kWorld =
    "format = 1\nname = \"w\"\n[[wall]]\npoints = [[0, 0], [6, 0], [6, 6], [0, 6]]\nclosed = true\n"
    "[[mover]]\nid = \"m\"\nlength_m = 0.4\nwidth_m = 0.4\nplaces = [[1, 1], [5, 5], [1, 5]]\nchange_after_s = [0.2, "
    "1]\n";

std::string every_sensor() {
  std::string text;
  for (const SensorKind* kind : testing::kSensors) {
    text += fmt::format("[[sensor]]\nid = \"s_{0}\"\nkind = \"{0}\"\n", kind->descriptor.name);
  }
  return text + "[[task]]\nid = \"app\"\nkind = \"GoTo\"\npatience_s = 0.5\nmax_turn_deg = 45\n";
}

TEST(Simulation, TakesNoMemoryInStepsWhateverTheKinds) {
  for (const DriveKind* drive : testing::kDrives) {
    testing::Trial trial(kWorld, fmt::format("[drive]\nkind = \"{}\"\n", drive->descriptor.name) + every_sensor(),
                         SpawnRandom{}, 8);
    const std::uint64_t before = ::ganglion::testing::allocations();
    for (int n = 0; n < 100; ++n) {
      const double value = n % 20 < 15 ? 1 : -0.5;
      trial.go({value, n % 3 * 0.5 - 0.5}, 0.1);
    }
    EXPECT_EQ(::ganglion::testing::allocations() - before, 0u) << drive->descriptor.name;
  }
}

}  // namespace
}  // namespace ganglion::sim
