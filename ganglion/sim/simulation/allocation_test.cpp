// Counts what this test program allocates, to show that a step takes no memory.
#include <atomic>
#include <cstdlib>
#include <new>

#include "ganglion/sim/simulation/testing.h"

namespace {
std::atomic<long> allocations{0};
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size != 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
void* operator new[](std::size_t size) { return operator new(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace ganglion::sim {
namespace {

constexpr std::string_view kWorld =
    "format = 1\nname = \"w\"\n[[wall]]\npoints = [[0, 0], [6, 0], [6, 6], [0, 6]]\nclosed = true\n"
    "[[mover]]\nid = \"m\"\nlength_m = 0.4\nwidth_m = 0.4\nplaces = [[1, 1], [5, 5], [1, 5]]\nchange_after_s = [0.2, 1]\n";

std::string every_sensor() {
  std::string text;
  for (const SensorKind* kind : testing::kSensors) {
    text += fmt::format("[[sensor]]\nid = \"s_{0}\"\nkind = \"{0}\"\n", kind->descriptor.name);
  }
  return text + "patience_s = 0.5\n";  // the last one is the trainer
}

TEST(Simulation, TakesNoMemoryInStepsWhateverTheKinds) {
  for (const DriveKind* drive : testing::kDrives) {
    testing::Trial trial(kWorld, fmt::format("[drive]\nkind = \"{}\"\n", drive->descriptor.name) + every_sensor(),
                         SpawnRandom{}, 8);
    const long before = allocations;
    for (int n = 0; n < 100; ++n) {
      const double value = n % 20 < 15 ? 1 : -0.5;
      trial.go({value, n % 3 * 0.5 - 0.5}, 0.1);
    }
    EXPECT_EQ(allocations - before, 800) << drive->descriptor.name;  // only go() itself: 8 lists of values a step
  }
}

}  // namespace
}  // namespace ganglion::sim
