#include "ganglion/coordination/priority/priority.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "ganglion/module/testing/allocations.h"

namespace ganglion {
namespace {

/// Three candidates. What every coordinator tells of them (active, share, wanted, suppressed) the graph works out.
class PriorityTest : public ::testing::Test {
 protected:
  PriorityTest() { product_ = std::move(*priority_kind.make(Parameters(priority_kind.descriptor.parameters))); }
  Command coordinate() {
    const std::array<const Command*, 3> pointers = {&candidates[0], &candidates[1], &candidates[2]};
    shares = {};
    return product_->coordinate({}, pointers, shares);
  }

  std::array<Command, 3> candidates{};
  std::array<double, 3> shares{};

 private:
  std::unique_ptr<Coordinator> product_;
};

using Three = std::array<double, 3>;

TEST_F(PriorityTest, LetsTheFirstThatCommandsDrive) {
  candidates[1] = Command::act({0.1, -0.1});
  candidates[1].ttl_s = 0.04;
  candidates[2] = Command::act({0.3, 0.3});
  const Command command = coordinate();
  EXPECT_EQ(command.kind, CommandKind::Act);
  EXPECT_EQ(command.size, 2);
  EXPECT_EQ(command.values[0], 0.1);
  EXPECT_EQ(command.ttl_s, 0.04);
  EXPECT_EQ(shares, (Three{0, 1, 0}));
}

TEST_F(PriorityTest, PassesOverAWithdrawal) {
  candidates[0] = Command::withdraw({ReasonCode::Trapped, 1, 2});
  candidates[2] = Command::act({0.3, 0.3});
  EXPECT_EQ(coordinate().values[1], 0.3);
  EXPECT_EQ(shares, (Three{0, 0, 1}));
}

TEST_F(PriorityTest, IsInactiveWhereNobodyCommands) {
  candidates[1] = Command::withdraw({ReasonCode::Trapped, 1, 2});
  EXPECT_EQ(coordinate().kind, CommandKind::Inactive);
  EXPECT_EQ(shares, (Three{0, 0, 0}));
}

TEST_F(PriorityTest, WithdrawsForTheFirstReasonWhereAllHaveWithdrawn) {
  candidates[0] = Command::withdraw({ReasonCode::NoReading, 4, 2});
  candidates[1] = Command::withdraw({ReasonCode::Trapped, 1, 2});
  candidates[2] = Command::withdraw({ReasonCode::Unreachable, 1, 2});
  const Command command = coordinate();
  EXPECT_EQ(command.kind, CommandKind::Withdraw);
  EXPECT_EQ(command.reason.code, ReasonCode::NoReading);
  EXPECT_EQ(command.reason.first, 4);
  EXPECT_EQ(shares, (Three{0, 0, 0}));
}

TEST_F(PriorityTest, TakesNoMemory) {
  candidates[2] = Command::act({0.3, 0.3});
  const std::uint64_t before = testing::allocations();
  coordinate();
  EXPECT_EQ(testing::allocations(), before);
}

}  // namespace
}  // namespace ganglion
