#include <gtest/gtest.h>

#include <array>

#include "ganglion/module/testing/request_bench.h"

namespace ganglion {
namespace {

constexpr Text kAny = Text::same("any");
constexpr std::array kPorts = {
    PortDescriptor{.name = "goal", .title = kAny, .help = kAny, .role = PortRole::Request},
    PortDescriptor{.name = "place", .title = kAny, .help = kAny, .role = PortRole::Feedback},
    PortDescriptor{.name = "step", .title = kAny, .help = kAny, .role = PortRole::Command},
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
    granted = feedback.granted();
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

/// Asked for n, it seeks the place n + 10, and tells how its last command was carried out.
class Translator final : public ActingModule {
 public:
  double share = -1;

 private:
  void internal_adaptation(const Feedback&, Cost) noexcept override {}
  Command internal_propagation(const Request&, const Feedback& feedback) noexcept override {
    share = feedback.share;
    return Command::act({1});
  }
  void seek(const Request& fresh, const Feedback& feedback, Sought& into) const noexcept override {
    const double meant = fresh.values[0] + 10 + feedback.value(1);  // where it was when it was asked
    into.set({&meant, 1});
  }
};

TEST(ActingModule, HoldsItsReadingAgainstWhatItSoughtWhenTheRequestWasFresh) {
  Translator module;
  testing::RequestBench bench(module, kDescriptor);
  bench.ports().set("place", {2});
  bench.ask({5});
  bench.tick(std::nullopt);  // 5 + 10 + 2 = 17 from here on
  bench.ports().set("place", {5});
  bench.tick(1);
  EXPECT_EQ(bench.request().status, RequestStatus::Pending) << "the request itself is not what it seeks";
  bench.ports().set("place", {17});
  bench.tick(1);
  EXPECT_EQ(bench.request().status, RequestStatus::Satisfied);
}

TEST(ActingModule, HearsWhatPartOfItsCommandWasCarriedOutAndLearnsOnlyFromTheWhole) {
  Probe probe;
  testing::RequestBench bench(probe, kDescriptor);
  bench.ask({5});
  bench.tick(std::nullopt);
  probe.carried_out(0.5);
  bench.tick(1);
  EXPECT_EQ(probe.adaptations, 0);
  EXPECT_FALSE(probe.granted);
  EXPECT_FALSE(bench.request().has_cost) << "what a blend cost is nobody's";
  probe.carried_out(1);
  bench.tick(1);
  EXPECT_EQ(probe.adaptations, 1);
  EXPECT_EQ(bench.request().cost, 1);
}

class AStandingRequest : public ::testing::Test {
 protected:
  AStandingRequest() : bench(module, kDescriptor) { bench.request().standing = true; }
  Translator module;
  testing::RequestBench bench;
};

TEST_F(AStandingRequest, IsNeverSatisfiedAndCostsWhatTheLastTickCost) {
  bench.request().keep_asking(std::array{5.0}, 0.2);
  bench.tick(std::nullopt);
  bench.ports().set("place", {15});
  bench.tick(3);
  bench.tick(4);
  EXPECT_EQ(bench.request().status, RequestStatus::Pending);
  EXPECT_EQ(bench.request().cost, 4) << "not the sum of 7";
}

TEST_F(AStandingRequest, IsMadeAnewOnlyByOtherValues) {
  bench.request().keep_asking(std::array{5.0}, 0.2);
  EXPECT_EQ(bench.request().serial, 1u);
  bench.request().keep_asking(std::array{5.0}, 0.2);
  EXPECT_EQ(bench.request().serial, 1u);
  bench.request().keep_asking(std::array{6.0}, 0.2);
  EXPECT_EQ(bench.request().serial, 2u);
}

TEST_F(AStandingRequest, LetsNoCommandLastLongerThanItself) {
  bench.request().keep_asking(std::array{5.0}, 0.04);
  EXPECT_EQ(bench.tick(std::nullopt).ttl_s, 0.04);
}

TEST_F(AStandingRequest, LetsTheModuleAboveGoOnAndPayTickByTick) {
  Probe upper;
  testing::RequestBench above(upper, kDescriptor);
  above.join_below(bench.request());
  above.ask({1});
  above.tick(std::nullopt);
  EXPECT_FALSE(upper.waits());
  bench.tick(std::nullopt);
  bench.tick(2);
  above.tick(std::nullopt);
  EXPECT_EQ(upper.adaptations, 1) << "it learned from the tick of 2 J";
  EXPECT_TRUE(upper.granted);
}

/// Gives up for the second of its kind's own reasons.
class Quitter final : public ActingModule {
  void internal_adaptation(const Feedback&, Cost) noexcept override {}
  Command internal_propagation(const Request&, const Feedback&) noexcept override {
    return Command::withdraw({own_reason(1), 3, 4});
  }
};

TEST(ActingModule, SendsAReasonOfItsOwnWithTheCommonOneItIsACaseOf) {
  Quitter module;
  testing::RequestBench bench(module, kDescriptor);
  const std::array likes = {ReasonCode::NoReading, ReasonCode::Trapped};
  bench.join_likes(likes);
  bench.ask({5});
  const Reason reason = bench.tick(std::nullopt).reason;
  EXPECT_EQ(reason.code, own_reason(1));
  EXPECT_EQ(reason.common().code, ReasonCode::Trapped);
  EXPECT_EQ(reason.common().first, 3);
  EXPECT_EQ(bench.request().reason.common().code, ReasonCode::Trapped);
}

}  // namespace
}  // namespace ganglion
