#pragma once

#include "ganglion/module/testing/habits.h"

namespace ganglion::testing {

/// What a sensing module must do on any readings: run without taking memory, the same each time. `check` looks at the
/// outputs after each tick.
template <class Check>
void expect_good_sensing(const SensingModuleKind& kind, std::initializer_list<Setting> list,
                         std::initializer_list<std::string_view> optional_ports, const Check& check) {
  step_twins<SensingBench>(kind, list, optional_ports, 0.1, [&](SensingBench& bench, SensingBench& twin) {
    check(bench);
    for (const PortDescriptor& port : kind.descriptor.ports) {
      if (port.role != PortRole::Output) continue;
      const double value = bench.out(port.name);
      const double other = twin.out(port.name);
      ASSERT_TRUE(value == other || (std::isnan(value) && std::isnan(other))) << port.name;
    }
  });
}

}  // namespace ganglion::testing
