#include "ganglion/run/run.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <limits>

#include "ganglion/base/file.h"

namespace ganglion {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

double value_of(const Measures& measures, std::string_view name) {
  const auto found = std::find_if(measures.begin(), measures.end(), [&](const auto& m) { return m.first == name; });
  EXPECT_NE(found, measures.end()) << name;
  return found == measures.end() ? kInf : found->second;
}

/// Nimrod for 20 s on a field that rises 30 deg to the east, heading uphill, its body changed.
Measures on_a_hillside(const char* slope_deg, const char* limit) {
  namespace fs = std::filesystem;
  const fs::path world = fs::temp_directory_path() / fmt::format("ganglion_hillside_{}.toml", ::getpid());
  EXPECT_TRUE(write_file(world, fmt::format("format = 1\n[[floor]]\nx_m = 0\ny_m = 0\nlength_m = 40\nwidth_m = 40\n"
                                            "slope_deg = {}\n",
                                            slope_deg)));
  Problems problems;
  const auto prepared = prepare(fs::path(GANGLION_SOURCE_DIR) / "experiments/nimrod",
                                {{"run.duration_s", "20"},
                                 {"run.free_ground", "false"},
                                 {"application.world", world.string()},
                                 {"application.spawn", "{pose = [0, 0, 0]}"},
                                 {std::string("application.robot.body.") + limit, "20"}},
                                problems);
  EXPECT_TRUE(prepared) << problems.text();
  const auto result = run(*prepared, {});
  EXPECT_TRUE(result) << result.error().text();
  fs::remove(world);
  return result->measures;
}

TEST(ARun, IsJudgedByTheCriteriaOfItsExperimentOrNotAtAll) {
  Problems problems;
  auto prepared =
      prepare(std::filesystem::path(GANGLION_SOURCE_DIR) / "experiments/nimrod", {{"run.duration_s", "1"}}, problems);
  ASSERT_TRUE(prepared) << problems.text();
  const auto verdict = [&](std::vector<Criterion> success, bool stopped = false) {
    prepared->experiment.success = std::move(success);
    RunOptions options;
    options.stop = [stopped] { return stopped; };
    const auto result = run(*prepared, options);
    EXPECT_TRUE(result) << result.error().text();
    return result->verdict;
  };
  const Criterion met = *parse_criterion("duration_s >= 1"), missed = *parse_criterion("duration_s > 100");
  EXPECT_EQ(verdict({}), Verdict::NotJudged);
  EXPECT_EQ(verdict({met}), Verdict::Succeeded);
  EXPECT_EQ(verdict({met, missed}), Verdict::Failed);
  EXPECT_EQ(verdict({}, true), Verdict::Failed);  // interrupted
}

TEST(RobotMeasures, TellForHowLongTheRobotLayOnItsSide) {
  const Measures measures = on_a_hillside("30", "tip_deg");
  EXPECT_NEAR(value_of(measures, "tipped_s"), 20, 1e-9);  // from the first moment
  EXPECT_EQ(value_of(measures, "stalled_s"), 0);
  EXPECT_EQ(value_of(measures, "travelled_m"), 0);
}

TEST(RobotMeasures, TellForHowLongASlopeWasTooSteep) {
  const Measures measures = on_a_hillside("30", "climb_deg");
  EXPECT_GT(value_of(measures, "stalled_s"), 15);  // whenever it does not turn
  EXPECT_LE(value_of(measures, "stalled_s"), 20 + 1e-9);
  EXPECT_EQ(value_of(measures, "tipped_s"), 0);
  EXPECT_NEAR(value_of(measures, "progress_m"), 0, 1e-9);
  EXPECT_EQ(value_of(on_a_hillside("19", "climb_deg"), "stalled_s"), 0);
}

TEST(RobotMeasures, LeaveOutSlopesWhereThereAreNone) {
  const Measures level = on_a_hillside("0", "tip_deg");
  EXPECT_TRUE(std::ranges::none_of(level, [](const auto& one) { return one.first == "tipped_s"; }));
}

}  // namespace
}  // namespace ganglion
