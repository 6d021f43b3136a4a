#pragma once

#include "ganglion/module/testing/habits.h"

namespace ganglion::testing {

/// What a sensing module must do on any readings: run without taking memory, the same each time. `check` looks at the
/// outputs after each tick.
template <class Check>
void expect_good_sensing(const SensingModuleKind& kind, std::initializer_list<Setting> list,
                         std::initializer_list<std::string_view> optional_ports, const Check& check) {
  SensingBench bench(kind, list);
  SensingBench twin(kind, list);
  for (const std::string_view port : optional_ports) {
    bench.wire(port, 1);
    twin.wire(port, 1);
  }
  bench.step(0.1);
  twin.step(0.1);
  for (std::uint32_t i = 0; i < 2000; ++i) {
    Draws draws({.seed = 7}, i);
    Draws again({.seed = 7}, i);
    draw_readings(bench.wired(), draws);
    draw_readings(twin.wired(), again);
    const std::uint64_t before = allocations();
    bench.step(0.1);
    ASSERT_EQ(allocations(), before) << "tick " << i;
    twin.step(0.1);
    check(bench);
    for (const PortDescriptor& port : kind.descriptor.ports) {
      if (port.role != PortRole::Output) continue;
      const double value = bench.out(port.name);
      const double other = twin.out(port.name);
      ASSERT_TRUE(value == other || (std::isnan(value) && std::isnan(other))) << port.name << " tick " << i;
    }
  }
}

}  // namespace ganglion::testing
