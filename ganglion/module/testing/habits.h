#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "ganglion/module/testing/allocations.h"
#include "ganglion/module/testing/bench.h"

namespace ganglion::testing {

/// Fills every wired value with one of the readings that REP-117 knows, or an ordinary one of an angle or range.
inline void draw_readings(const std::vector<std::span<double>>& ports, Draws& draws) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  constexpr std::array kReadings = {
      std::numeric_limits<double>::quiet_NaN(), kInf, -kInf, 0.0, -0.0, 1.0, 0.05, 0.2, 0.39, 2.5, -3.1, 1e300};
  for (const std::span<double> port : ports) {
    for (double& value : port) value = kReadings[draws.below(kReadings.size())];
  }
}

/// Steps two products of a kind side by side on 2000 draws of any readings, which must take no memory. After each step
/// `compare` is shown both.
template <class Bench, class Product, class Compare>
void step_twins(const Kind<Product>& kind, std::initializer_list<Setting> list,
                std::initializer_list<std::string_view> optional_ports, double step_s, const Compare& compare) {
  Bench bench(kind, list);
  Bench twin(kind, list);
  for (const std::string_view port : optional_ports) {
    bench.wire(port, 1);
    twin.wire(port, 1);
  }
  bench.step(step_s);
  twin.step(step_s);
  for (std::uint32_t i = 0; i < 2000; ++i) {
    SCOPED_TRACE("tick " + std::to_string(i));
    Draws draws({.seed = 7}, i);
    Draws again({.seed = 7}, i);
    draw_readings(bench.wired(), draws);
    draw_readings(twin.wired(), again);
    const std::uint64_t before = allocations();
    bench.step(step_s);
    ASSERT_EQ(allocations(), before);
    twin.step(step_s);
    compare(bench, twin);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

/// What a behaviour must do on any readings: command finite values within +-1 or nothing, without taking memory, the
/// same each time.
inline void expect_good_habits(const ActingModuleKind& kind, std::initializer_list<Setting> list,
                               std::initializer_list<std::string_view> optional_ports, double step_s) {
  step_twins<ActingBench>(kind, list, optional_ports, step_s, [](ActingBench& bench, ActingBench& twin) {
    const Command& command = bench.product().command();
    const Command& other = twin.product().command();
    ASSERT_EQ(command.kind, other.kind);
    ASSERT_EQ(command.values, other.values);
    if (command.kind != CommandKind::Act) return;
    ASSERT_GT(command.ttl_s, 0);
    for (const double value : command.span()) ASSERT_LE(std::fabs(value), 1);  // false for NaN
  });
}

}  // namespace ganglion::testing
