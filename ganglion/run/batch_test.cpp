#include "ganglion/run/batch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ganglion {
namespace {

TEST(Quantile, InterpolatesAsRsTypeSeven) {
  EXPECT_EQ(quantile({1, 2, 3, 4}, 0.25), 1.75);  // R: quantile(1:4)
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_EQ(quantile({7}, 0.75), 7);
  EXPECT_EQ(quantile({NAN, 3}, 0.5), 3);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
  EXPECT_EQ(quantile({INFINITY, INFINITY, 1}, 0.75), INFINITY);
}

}  // namespace
}  // namespace ganglion
