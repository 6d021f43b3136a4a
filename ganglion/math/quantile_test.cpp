#include "ganglion/math/quantile.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ganglion::math {
namespace {

TEST(Quantile, InterpolatesAsRsTypeSeven) {
  EXPECT_EQ(quantile({1, 2, 3, 4}, 0.25), 1.75);  // R: quantile(1:4)
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_EQ(quantile({7}, 0.75), 7);
}

TEST(Quantile, LeavesOutWhatIsNoNumber) {
  EXPECT_EQ(quantile({NAN, 3}, 0.5), 3);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
  EXPECT_TRUE(std::isnan(quantile({NAN}, 0.5)));
}

TEST(Quantile, CountsInfinities) {
  EXPECT_EQ(quantile({INFINITY, INFINITY, 1}, 0.75), INFINITY);
  EXPECT_EQ(quantile({INFINITY, 2, 1}, 0.5), 2);  // beside an infinity, and still a number
}

}  // namespace
}  // namespace ganglion::math
