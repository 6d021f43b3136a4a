// What a tick costs: controllers of 50 components and, for the slope, of 100, 200 and 400.
#include "bench/support/rows.h"
#include "ganglion/graph/testing/rig.h"
#include "ganglion/module/testing/allocations.h"

namespace {

using namespace ganglion::bench;
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

/// CPU microseconds of a tick. Requests come and go; no tick may take memory from the heap.
double tick_us(int components, std::uint64_t& allocations) {
  Rig rig(controller(components));
  rig.cost = 0.1;
  rig.tick(10);
  constexpr int kTicks = 100'000;
  const std::uint64_t before = ganglion::testing::allocations();
  const double began_s = cpu_s();
  for (int n = 0; n < kTicks; ++n) {
    ++rig.sense.tick;
    rig.sense.values[0] = static_cast<double>(rig.sense.tick % 9);
    rig.controller.tick(rig.sense, 0.1, rig.act);
  }
  const double took_s = cpu_s() - began_s;
  allocations += ganglion::testing::allocations() - before;
  return took_s * 1e6 / kTicks;
}

double compile_ms(int components) {
  const std::string text = controller(components);
  ganglion::Problems problems;
  const double began_s = cpu_s();
  const auto made = ganglion::testing::compiled(text, problems);
  return made ? (cpu_s() - began_s) * 1e3 : -1;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<Row> rows;
  std::uint64_t allocations = 0;
  for (const int components : {50, 100, 200, 400}) {
    rows.push_back(
        measured("cycle/" + std::to_string(components), "us", [&] { return tick_us(components, allocations); }));
  }
  rows.push_back({"cycle/allocations", static_cast<double>(allocations), std::nullopt, "in all those ticks"});
  for (const int components : {50, 400, 1000}) {
    rows.push_back(
        measured("cycle/compile/" + std::to_string(components), "ms", [&] { return compile_ms(components); }));
  }
  return print(rows, argc, argv, "cycle/N: a tick of a controller of N components.\n");
}
