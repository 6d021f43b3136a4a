#include "ganglion/math/functions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ganglion {
namespace {

TEST(MathFunctions, StayWithinTwoUlpOfTheStandardLibrary) {
  for (int i = -400; i <= 400; ++i) {
    const double x = i * 0.0173;
    EXPECT_NEAR(math::sin(x), std::sin(x), 3e-16);
    EXPECT_NEAR(math::cos(x), std::cos(x), 3e-16);
    EXPECT_NEAR(math::atan2(x, 0.7), std::atan2(x, 0.7), 5e-16);
    EXPECT_NEAR(math::exp(x) / std::exp(x), 1, 5e-16);
    const auto both = math::sincos(x);
    EXPECT_NEAR(both.sin, std::sin(x), 3e-16);
    EXPECT_NEAR(both.cos, std::cos(x), 3e-16);
  }
}

TEST(MathFunctions, HitTheirExactPoints) {
  EXPECT_EQ(math::sin(0), 0);
  EXPECT_EQ(math::cos(0), 1);
  EXPECT_EQ(math::hypot(3, 4), 5);
  EXPECT_EQ(math::pow(2, 10), 1024);
  EXPECT_EQ(math::log(1), 0);
}

}  // namespace
}  // namespace ganglion
