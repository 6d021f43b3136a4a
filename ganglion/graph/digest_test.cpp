#include "ganglion/graph/digest.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "ganglion/graph/testing/rig.h"

namespace ganglion {
namespace {

using testing::gain, testing::Rig, testing::seeker, testing::sensations, testing::wish;

const std::string kNoise = "[[sensing]]\nid = \"noise\"\nkind = \"Noise\"\n";

const std::string kSeeker =
    wish("wish", "values = [4]") + seeker("seeker", "wish", "stride = 0.125\nrelative = true\ncommand = \"move\"");

/// Ten ticks of a run in which the robot moves as it is told.
void run(Rig& rig) {
  for (int i = 0; i < 10; ++i) {
    rig.set("a", 0.1 * i);
    rig.set("place", rig.sense.values[0] + rig.command("move"));
    rig.tick();
  }
}

Rig after(const std::string& text, const Identity& identity = {}) {
  Rig rig(text, identity);
  run(rig);
  return rig;
}

std::string whole() { return sensations({"place", "a"}) + gain("three", "a", 3) + kNoise + kSeeker; }

TEST(Digest, IsTheSameForTheSameRun) {
  EXPECT_EQ(after(whole()).controller.digest().total(), after(whole()).controller.digest().total());
}

TEST(Digest, DoesNotDependOnTheOrderOfTheFile) {
  const std::string turned = kSeeker + kNoise + gain("three", "a", 3) + sensations({"a", "place"});
  EXPECT_EQ(after(whole()).controller.digest().total(), after(turned).controller.digest().total());
}

TEST(Digest, OfAComponentDoesNotDependOnUnrelatedOnes) {
  const Rig with = after(whole() + gain("more", "place", 3));
  const Rig without = after(whole());
  for (const char* id : {"place", "a", "three", "noise", "wish", "seeker"}) {
    EXPECT_EQ(with.digest(id), without.digest(id)) << id;
  }
  EXPECT_NE(with.controller.digest().total(), without.controller.digest().total());
}

TEST(Digest, DiffersWhereOneBitDoes) {
  Rig one(whole()), other(whole());
  run(one);
  run(other);
  one.set("a", 1);
  other.set("a", std::nextafter(1.0, 2.0));
  one.tick();
  other.tick();
  EXPECT_NE(one.digest("a"), other.digest("a"));
  EXPECT_EQ(one.digest("place"), other.digest("place"));
  EXPECT_NE(one.controller.digest().total(), other.controller.digest().total());
}

TEST(Digest, DiffersWhereAValueMovesToAnotherComponentOrTick) {
  Digest digest;
  const std::size_t a = digest.join(0, "a"), b = digest.join(0, "b");
  Digest same = digest, moved = digest, later = digest, robot;
  robot.join(1, "a");
  robot.join(1, "b");
  const std::array value = {1.0}, nothing = {0.0};
  same.add(a, 1, value);
  same.add(b, 1, nothing);
  moved.add(a, 1, nothing);
  moved.add(b, 1, value);
  later.add(a, 2, value);
  later.add(b, 2, nothing);
  robot.add(a, 1, value);
  robot.add(b, 1, nothing);
  EXPECT_NE(same.total(), moved.total());
  EXPECT_NE(same.total(), later.total());
  EXPECT_NE(same.total(), robot.total());
}

TEST(Digest, TakesAllNotANumbersAndBothZerosForOne) {
  Digest one, other;
  one.join(0, "a");
  other.join(0, "a");
  const double payload = std::bit_cast<double>(std::uint64_t{0xfff8000000000001});
  one.add(0, 1, std::array{std::numeric_limits<double>::quiet_NaN(), 0.0});
  other.add(0, 1, std::array{payload, -0.0});
  EXPECT_EQ(one.total(), other.total());
}

TEST(Digest, FollowsTheCommandFrame) {
  Rig one(whole()), other(whole());
  one.set("place", 0);
  other.set("place", 4.5);  // back instead of forth
  one.tick();
  other.tick();
  EXPECT_NE(one.command("move"), other.command("move"));
  EXPECT_NE(one.controller.digest().total(), other.controller.digest().total());
}

TEST(Identity, ChangesNothingButChance) {
  const Rig first = after(whole(), {.seed = 7});
  for (const Identity& identity :
       {Identity{.seed = 7, .robot = 1}, Identity{.seed = 7, .episode = 1}, Identity{.seed = 8}}) {
    const Rig other = after(whole(), identity);
    EXPECT_NE(first.signal("noise.out"), other.signal("noise.out"));
    for (std::size_t i = 0; i < first.controller.signals().size(); ++i) {
      if (first.controller.signals()[i].name == "noise.out") continue;
      EXPECT_EQ(first.controller.values()[i], other.controller.values()[i]) << first.controller.signals()[i].name;
    }
  }
}

TEST(Digest, IsWrittenAsSixteenHexadecimalDigits) { EXPECT_EQ(hex(0xabc), "0000000000000abc"); }

}  // namespace
}  // namespace ganglion
