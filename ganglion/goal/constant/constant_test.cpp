#include "ganglion/goal/constant/constant.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace ganglion {
extern const GlobalGoalKind constant_kind;
namespace {

TEST(ConstantGoal, WantsItsValuesAtEveryTickWhateverBecomesOfThem) {
  Parameters parameters(constant_kind.descriptor.parameters);
  parameters.set_reals("value", {7, -2.5});
  parameters.set("intensity", 0.5);
  const auto goal = constant_kind.make(parameters).value();
  for (int i = 0; i < 2; ++i) {
    goal->decide(Tick{});
    const Bid& bid = goal->wanted();
    EXPECT_EQ(std::vector<double>(bid.values.begin(), bid.values.end()), (std::vector<double>{7, -2.5}));
    EXPECT_EQ(bid.intensity, 0.5);
    EXPECT_FALSE(bid.replaces);
    goal->concluded(RequestStatus::Withdrawn, {});
  }
}

TEST(ConstantGoal, RefusesValuesThatCannotBeARequest) {
  const std::vector<double> lost = {std::numeric_limits<double>::quiet_NaN()};
  for (const auto& value : {std::vector<double>{}, std::vector<double>(17, 1.0), lost}) {
    const auto made = ConstantGoal::judge({value});
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::BadParameter);
  }
}

}  // namespace
}  // namespace ganglion
