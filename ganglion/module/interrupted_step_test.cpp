#include <gtest/gtest.h>

#include "ganglion/module/testing/request_bench.h"

namespace ganglion {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "goal", .role = PortRole::Request},
    PortDescriptor{.name = "place", .role = PortRole::Feedback},
    PortDescriptor{.name = "step", .role = PortRole::Command},
};
constexpr Descriptor kDescriptor{.component_class = ComponentClass::Acting, .name = "Probe", .ports = kPorts};

/// Commands 1 for ever and notes how it was called.
class Probe final : public ActingModule {
 public:
  int adaptations = 0;
  bool granted = true;

 private:
  void internal_adaptation(const Feedback&, Cost) noexcept override { ++adaptations; }
  Command internal_propagation(const Request&, const Feedback& feedback) noexcept override {
    granted = feedback.granted;
    return Command::act({1});
  }
};

TEST(ActingModule, DoesNotLearnFromAStepThatANewRequestBrokeOff) {
  Probe probe;
  testing::RequestBench bench(probe, kDescriptor);
  RequestSlot below;
  bench.join_below(below);
  bench.ask({5});
  bench.tick(std::nullopt);
  below.cost = 2;
  below.has_cost = true;
  bench.ask({7});  // replaced while the step is still pending below
  bench.tick(1);
  EXPECT_EQ(probe.adaptations, 0);
  EXPECT_FALSE(probe.granted);
  below.cost = 2;
  below.has_cost = true;
  below.status = RequestStatus::Satisfied;
  bench.tick(1);
  EXPECT_EQ(probe.adaptations, 1);
  EXPECT_TRUE(probe.granted);
}

}  // namespace
}  // namespace ganglion
