#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "ganglion/graph/testing/rig.h"

namespace ganglion {
namespace {

using testing::first, testing::puppet, testing::Rig, testing::seeker, testing::sensations, testing::wish;

/// Any double: whatever 64 bits there are, and more often those that hurt.
rc::Gen<double> any_double() {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  return rc::gen::oneOf(
      rc::gen::element(std::numeric_limits<double>::quiet_NaN(), kInf, -kInf, -0.0, 1e308, -1e308, 5e-324, 1.0, 2.0),
      rc::gen::map(rc::gen::arbitrary<std::uint64_t>(),
                   [](std::uint64_t bits) { return std::bit_cast<double>(bits); }));
}

/// Commands on all three channels: straight, by a coordinator, and from a hierarchy with goals of every temper.
std::string everything() {
  return sensations({"place", "a", "b", "c", "d", "pair", "heading"}) +
         wish("trainer", "in.wish = \"c\"\nin.strength = \"d\"\nreplaces = true") +
         wish("alarm", "in.wish = \"place\"\nin.wanted = \"a\"\npriority_class = 1") + wish("turn", "in.wish = \"b\"") +
         seeker("lower", "upper", "relative = true") + puppet("puppet", "a", "b", "in.ttl_s = \"c\"") +
         first("arbiter", R"("puppet", "lower")", "command = \"move\"") +
         puppet("driver", "a", "pair", "in.ttl_s = \"d\"\ncommand = \"drive\"") + R"([[acting]]
id = "upper"
kind = "Seeker"
in.goal = ["trainer", "alarm"]
in.place = "place"
give_up_at = 3
[[acting]]
id = "turner"
kind = "Turner"
in.goal = "turn"
in.place = "heading"
command = "grip"
[[sensing]]
id = "sum"
kind = "Sum"
in.in = ["a", "b", "move.x@previous", "sum@previous"]
)";
}

void expect_sound(const Rig& rig, const Description& robot) {
  std::size_t i = 0;
  for (const CommandChannel& channel : robot.commands) {
    for (const CommandElement& element : channel.elements) {
      const double value = rig.act.values[i++];
      RC_ASSERT(std::isfinite(value));
      RC_ASSERT(value >= element.min);
      RC_ASSERT(value <= element.max);
    }
  }
  for (const double ttl_s : rig.act.ttl_s) RC_ASSERT(ttl_s >= 0 && ttl_s <= 0.3);
}

RC_GTEST_PROP(Controller, NeverSendsWhatIsNoNumberOrBeyondLimits, ()) {
  const Description robot = testing::test_robot();
  Rig rig(everything());
  for (int tick = 0; tick < 20; ++tick) {
    for (double& value : rig.sense.values) value = *any_double();
    for (double& age_s : rig.sense.ages_s) age_s = *any_double();
    rig.cost = *any_double();
    rig.tick();
    expect_sound(rig, robot);
    RC_ASSERT(rig.signal("lower.charged") == rig.signal("lower.charged"));  // no cost that is not a number
  }
}

TEST(Controller, ActsOnceReadingsAreBackAfterAnyNonsense) {
  Rig rig(everything());
  for (double& value : rig.sense.values) value = std::numeric_limits<double>::quiet_NaN();
  rig.tick(5);
  EXPECT_EQ(rig.origin("move"), CommandOrigin::Safe);
  for (double& value : rig.sense.values) value = 0;
  rig.set("c", 2);
  rig.set("d", 1);
  rig.tick();
  EXPECT_EQ(rig.command("move"), 1);
}

}  // namespace
}  // namespace ganglion
