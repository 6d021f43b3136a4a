/// What a tick costs: controllers of 50 components and, for the slope, of 100, 200 and 400. Beside the time each line
/// shows how often a tick took memory from the heap, which must be 0.
#include <benchmark/benchmark.h>

#include "ganglion/graph/testing/rig.h"
#include "ganglion/module/testing/allocations.h"

namespace {

using ganglion::testing::Rig;

/// Ten components: a sensation, a chain of four percepts, a goal, two acting modules in a hierarchy, a behaviour that
/// competes with them, and the coordinator of the three; `n` keeps their ids apart.
std::string cluster(int n) {
  std::string text = fmt::format("[[sensation]]\nid = \"s{0}\"\nchannel = \"place\"\n", n);
  for (int i = 0; i < 4; ++i) {
    const std::string from = i == 0 ? fmt::format("s{}", n) : fmt::format("n{}_{}", n, i - 1);
    text += fmt::format("[[sensing]]\nid = \"n{}_{}\"\nkind = \"Gain\"\nin.in = \"{}\"\ngain = 0.5\n", n, i, from);
  }
  return text + fmt::format(R"([[goal]]
id = "wish{0}"
kind = "Wish"
values = [9]
[[acting]]
id = "upper{0}"
kind = "Seeker"
in.goal = "wish{0}"
in.place = "s{0}"
[[acting]]
id = "lower{0}"
kind = "Seeker"
in.goal = "upper{0}"
in.place = "s{0}"
relative = true
[[acting]]
id = "reflex{0}"
kind = "Puppet"
in.act = "n{0}_3"
in.value = "n{0}_2"
[[coordinator]]
id = "arbiter{0}"
kind = "First"
in.commands = ["reflex{0}", "lower{0}"]
)",
                            n);
}

/// Clusters whose coordinators compete for `move`.
std::string controller(int components) {
  std::string text, list;
  for (int n = 0; n < components / 10; ++n) {
    text += cluster(n);
    list += fmt::format("\"arbiter{}\", ", n);
  }
  return text + "[[coordinator]]\nid = \"top\"\nkind = \"First\"\nin.commands = [" + list + "]\ncommand = \"move\"\n";
}

void tick(benchmark::State& state) {
  Rig rig(controller(static_cast<int>(state.range(0))));
  rig.cost = 0.1;
  rig.tick(10);
  const std::uint64_t before = ganglion::testing::allocations();
  for (auto step : state) {
    ++rig.sense.tick;
    rig.sense.values[0] = static_cast<double>(rig.sense.tick % 9);  // requests come and go
    rig.controller.tick(rig.sense, 0.1, rig.act);
    benchmark::DoNotOptimize(rig.act.values.data());
  }
  state.counters["allocations"] = static_cast<double>(ganglion::testing::allocations() - before);
  state.counters["signals"] = static_cast<double>(rig.controller.signals().size());
  state.counters["per_component"] = benchmark::Counter(static_cast<double>(state.iterations() * state.range(0)),
                                                       benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(tick)->Arg(50)->Arg(100)->Arg(200)->Arg(400)->Unit(benchmark::kMicrosecond);

void compile(benchmark::State& state) {
  const std::string text = controller(static_cast<int>(state.range(0)));
  for (auto step : state) {
    ganglion::Problems problems;
    benchmark::DoNotOptimize(ganglion::testing::compiled(text, problems));
  }
}
BENCHMARK(compile)->Arg(50)->Arg(400)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
