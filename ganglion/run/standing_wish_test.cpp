#include <gtest/gtest.h>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/run/run.h"

// A pathfinder that for half a minute is told to be 2 m from where it is, and believes itself at a goal that it has
// not reached. The goal stays, and once it sees that it is elsewhere it goes there.
namespace ganglion {
namespace {

namespace fs = std::filesystem;

class StandingWish : public FolderTest {
 protected:
  Prepared misled() const;
};

Prepared StandingWish::misled() const {
  const fs::path shipped = fs::path(GANGLION_SOURCE_DIR) / "experiments/pathfinder";
  const std::string text = fmt::format(R"(format = 1
name = "Misled"
controller = "{0}/controller.toml"
success = ["goals_missed <= 0", "goals_reached >= 20"]
[application]
robot = "{0}/robot.toml"
world = "{0}/rooms.toml"
[application.spawn]
id = "start"
[run]
duration_s = 3000
stop = ["goals_done >= 1"]
[[fault]]
target = "place.position"
kind = "biased"
amount = 2.0
from_s = 30
to_s = 60
)",
                                       shipped.string());
  EXPECT_TRUE(write_file(folder_ / "experiment.toml", text));
  Problems problems;
  auto made = prepare(folder_ / "experiment.toml", {}, problems);
  EXPECT_EQ(problems.text(), "");
  return made.value();
}

TEST_F(StandingWish, IsFulfilledThoughTheRobotBelievedItselfThere) {
  const Prepared prepared = misled();
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const auto result = run(prepared, {.seed = seed});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(result->verdict, Verdict::Succeeded) << "seed " << seed << ": " << result->reason.en;
  }
}

}  // namespace
}  // namespace ganglion
