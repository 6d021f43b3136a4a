#include "ganglion/coordination/weighted_sum/weighted_sum.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "ganglion/module/testing/allocations.h"

namespace ganglion {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

class WeightedSumTest : public ::testing::Test {
 protected:
  WeightedSumTest() {
    product_ = std::move(*weighted_sum_kind.make(Parameters(weighted_sum_kind.descriptor.parameters)));
  }
  Command coordinate(std::initializer_list<double> weights = {}) {
    std::array<double, 3> values{};
    std::copy(weights.begin(), weights.end(), values.begin());
    const std::array<PortView, 2> views = {PortView{},
                                           PortView{std::span<const double>(values).first(weights.size()), {}}};
    const std::array<const Command*, 3> pointers = {&candidates[0], &candidates[1], &candidates[2]};
    shares = {};
    const std::uint64_t before = testing::allocations();
    const Command command = product_->coordinate(Feedback{.ports = views}, pointers, shares);
    EXPECT_EQ(testing::allocations(), before);
    return command;
  }

  std::array<Command, 3> candidates{};
  std::array<double, 3> shares{};

 private:
  std::unique_ptr<Coordinator> product_;
};

using Three = std::array<double, 3>;

TEST_F(WeightedSumTest, IsTheMeanWhereNoWeightsAreWired) {
  candidates[0] = Command::act({1, 0});
  candidates[2] = Command::act({0, 0.5});
  const Command command = coordinate();
  EXPECT_EQ(command.kind, CommandKind::Act);
  EXPECT_EQ(command.size, 2);
  EXPECT_EQ(command.values[0], 0.5);
  EXPECT_EQ(command.values[1], 0.25);
  EXPECT_EQ(shares, (Three{0.5, 0, 0.5}));
}

TEST_F(WeightedSumTest, CountsEachAsMuchAsItWeighs) {
  candidates[0] = Command::act({1});
  candidates[1] = Command::act({-1});
  candidates[1].ttl_s = 0.2;
  candidates[2] = Command::act({0});
  const Command command = coordinate({3, 1, 4});  // (3 - 1) / 8
  EXPECT_EQ(command.values[0], 0.25);
  EXPECT_EQ(command.ttl_s, 0.2);
  EXPECT_EQ(shares, (Three{0.375, 0.125, 0.5}));
}

TEST_F(WeightedSumTest, LeavesOutWhatWeighsNothingOrIsNoNumber) {
  for (Command& candidate : candidates) candidate = Command::act({1});
  candidates[1] = Command::act({7});
  EXPECT_EQ(coordinate({kNaN, 2, -1}).values[0], 7);
  EXPECT_EQ(shares, (Three{0, 1, 0})) << "alone it was carried out whole";
  EXPECT_EQ(coordinate({0, 0, 0}).kind, CommandKind::Inactive);
  EXPECT_EQ(shares, (Three{0, 0, 0}));
}

TEST_F(WeightedSumTest, LeavesOutACommandOfAnotherWidth) {
  candidates[0] = Command::act({1, 1});
  candidates[1] = Command::act({5});
  EXPECT_EQ(coordinate().values[0], 1);
  EXPECT_EQ(shares, (Three{1, 0, 0}));
}

TEST_F(WeightedSumTest, WithdrawsWhereAllHave) {
  for (Command& candidate : candidates) candidate = Command::withdraw({ReasonCode::Trapped, 1, 2});
  candidates[0] = Command::withdraw({ReasonCode::NoReading, 4, 2});
  EXPECT_EQ(coordinate().reason.code, ReasonCode::NoReading);
  candidates[2] = Command::inactive();
  EXPECT_EQ(coordinate().kind, CommandKind::Inactive);
}

}  // namespace
}  // namespace ganglion
