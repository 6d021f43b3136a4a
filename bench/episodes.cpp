// Many short runs in one process: 1,000 episodes of a minute in the SB12 world of one robot, set-up included.
#include "bench/support/rows.h"
#include "bench/support/sb12.h"

namespace {

using namespace ganglion::bench;

constexpr std::uint32_t kEpisodes = 1000;
constexpr int kSteps = 600;  // of 0.1 s

/// A simulation for each episode, as `ganglion run` makes one for each seed, on one ground.
double seconds() {
  const double began_s = cpu_s();
  const Sb12Scene scene = sb12_scene(1);
  const auto ground = sb12_ground(scene);
  const auto model = sb12_robot(Eyes::IdealRays);
  for (std::uint32_t episode = 0; episode < kEpisodes; ++episode) {
    Sb12Run run({ground, model, 1, ganglion::sim::SpawnRandom{}});
    run.reset(1, episode);
    for (int n = 0; n < kSteps; ++n) run.step();
  }
  return cpu_s() - began_s;
}

}  // namespace

int main(int argc, char** argv) {
  return print({measured("episodes/1000x60s", "s", seconds)}, argc, argv,
               "1,000 episodes of 600 steps: start places drawn, ideal rays, latch avoider, nothing recorded. Rivals "
               "take\n4.3 s (Enki), 10 s (ARGoS) and 29 s (Stage) for as many processes of one episode each.\n");
}
