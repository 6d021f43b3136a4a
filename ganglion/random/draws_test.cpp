#include "ganglion/random/draws.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ganglion {
namespace {

TEST(Philox, GivesThePublishedAnswers) {  // known-answer vectors of the authors' Random123 distribution
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}),
            (std::array<std::uint32_t, 4>{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
            (std::array<std::uint32_t, 4>{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
}

TEST(Draws, DependOnTheirStreamAndTickAlone) {
  const StreamId stream{.seed = 7, .episode = 1, .robot = 2, .component = 3};
  Draws one(stream, 40), same(stream, 40), later(stream, 41);
  const auto first = one.bits();
  EXPECT_EQ(first, same.bits());
  EXPECT_NE(first, later.bits());
  EXPECT_NE(first, one.bits());
}

TEST(Draws, HaveTheStatedMomentsOverManyTicks) {
  const StreamId stream{.seed = 11};
  constexpr int kCount = 100000;
  double sum = 0, squares = 0, uniform_sum = 0;
  std::array<int, 5> faces{};
  for (std::uint32_t tick = 0; tick < kCount; ++tick) {
    Draws draws(stream, tick);
    const double x = draws.normal();
    sum += x;
    squares += x * x;
    uniform_sum += draws.uniform();
    ++faces[draws.below(5)];
  }
  EXPECT_NEAR(sum / kCount, 0, 5 / std::sqrt(kCount));  // five standard errors
  EXPECT_NEAR(squares / kCount, 1, 5 * std::sqrt(2.0 / kCount));
  EXPECT_NEAR(uniform_sum / kCount, 0.5, 5 * std::sqrt(1.0 / 12 / kCount));
  for (const int face : faces) EXPECT_NEAR(face, kCount / 5, 5 * std::sqrt(kCount * 0.16));
}

TEST(Draws, GiveTheSameNormalsOneByOneAndSideBySide) {
  for (std::size_t count = 1; count <= 9; ++count) {
    for (std::uint32_t tick = 0; tick < 2000; ++tick) {
      std::vector<Draws> alone, together;
      for (std::uint32_t n = 0; n < count; ++n)
        alone.emplace_back(StreamId{tick * 7919ull << 20, n, tick ^ n, n}, tick);
      together = alone;
      Draws::foresee_normals(together);
      for (std::size_t n = 0; n < count; ++n) {
        if (n == 4) EXPECT_EQ(alone[n].bits(), together[n].bits());  // whoever draws something else first is not misled
        ASSERT_EQ(alone[n].normal(), together[n].normal());
        ASSERT_EQ(alone[n].normal(), together[n].normal());
        ASSERT_EQ(alone[n].bits(), together[n].bits());
      }
    }
  }
}

}  // namespace
}  // namespace ganglion
