#include <gtest/gtest.h>
#include <unistd.h>

#include <map>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/run/run.h"

// The same experiment and seed give the same bits, whatever else goes on in the process, and for as long as it goes on.
namespace ganglion {
namespace {

namespace fs = std::filesystem;

const fs::path kExperiments = fs::path(GANGLION_SOURCE_DIR) / "experiments";

using Digests = std::map<std::string, std::string>;

Digests components(const RunResult& result) {
  return {result.component_digests.begin(), result.component_digests.end()};
}

config::Override set(const std::string& path, const std::string& value) {
  return *config::parse_override(path + "=" + value);
}

Prepared prepared(const fs::path& experiment, const std::vector<config::Override>& overrides) {
  Problems problems;
  auto made = prepare(experiment, overrides, problems);
  EXPECT_EQ(problems.text(), "");
  return made.value();
}

/// A Nimrod in the office for so long, without the second run on open ground.
Prepared nimrod(double duration_s, std::vector<config::Override> more = {}) {
  more.push_back(set("run.duration_s", std::to_string(duration_s)));
  more.push_back(set("run.free_ground", "false"));
  return prepared(kExperiments / "nimrod", more);
}

RunResult result_of(const Prepared& prepared, std::uint64_t seed) {
  auto result = run(prepared, {.seed = seed});
  EXPECT_TRUE(result) << result.error().text();
  return *result;
}

TEST(TheYard, IsCrossedWithAllSensorsOnAndRepeats) {
  const Prepared yard = prepared(kExperiments / "yard", {});
  const RunResult first = result_of(yard, 1), again = result_of(yard, 1), other = result_of(yard, 2);
  EXPECT_EQ(first.verdict, Verdict::Succeeded) << first.reason.en;
  EXPECT_EQ(components(first), components(again));
  EXPECT_NE(first.digest, other.digest);
  const RunResult weak = result_of(prepared(kExperiments / "yard", {set("application.robot.body.climb_deg", "6")}), 1);
  EXPECT_LT(measure(weak.measures, "progress_m"), 4.7);  // the ramp of 8 deg begins at 4.5 m; its foot, not its top
  EXPECT_GT(measure(weak.measures, "stalled_s"), 60);
}

TEST(SameBits, AfterAResetAsInAFreshSimulation) {
  const Prepared office = nimrod(20);
  const auto drive = [&](Application& simulation, std::uint64_t seed) {
    EXPECT_TRUE(simulation.reset(seed, 0));
    std::vector<SenseFrame> sense = {make_sense_frame(office.application->description())};
    std::vector<ActFrame> act = {make_act_frame(office.application->description())};
    std::vector<double> values;
    for (int tick = 0; tick < 300; ++tick) {
      simulation.sense(sense);
      values.insert(values.end(), sense[0].values.begin(), sense[0].values.end());
      values.insert(values.end(), sense[0].ages_s.begin(), sense[0].ages_s.end());
      values.push_back(sense[0].cost.value_or(-1));
      values.push_back(sense[0].time_s);
      for (double& value : act[0].values) value = tick % 40 < 30 ? 0.8 : -0.3;
      simulation.step(act, office.step_s);
    }
    std::vector<std::uint64_t> bits;
    for (const double value : values) bits.push_back(canonical_bits(value));
    return bits;
  };
  auto used = *office.application->make();
  const auto other = drive(*used, 8);
  auto fresh = *office.application->make();
  const auto expected = drive(*fresh, 9);
  EXPECT_EQ(drive(*used, 9), expected);
  EXPECT_NE(other, expected);
}

/// A hall of 600 x 600 m full of columns: many robots, and room for each.
std::string hall() {
  std::string text =
      "format = 1\nname = \"hall\"\n[[wall]]\npoints = [[0, 0], [600, 0], [600, 600], [0, 600]]\nclosed = true\n";
  for (int column = 1; column < 120; ++column) {
    for (int row = 1; row < 120; ++row) {
      text += fmt::format("[[disc]]\nx_m = {}\ny_m = {}\nradius_m = 0.3\n", 5 * column, 5 * row + column % 3);
    }
  }
  return text;
}

TEST(SameBits, AloneAndAmongAHundredRobots) {
  const fs::path file = fs::temp_directory_path() / fmt::format("ganglion_hall_{}.toml", ::getpid());
  ASSERT_TRUE(write_file(file, hall()));
  const config::Override world = set("application.world", "\"" + file.string() + "\"");
  const Digests alone = components(result_of(nimrod(30, {world}), 1));
  const Digests among = components(result_of(nimrod(30, {world, set("application.robots", "100")}), 1));
  fs::remove(file);
  EXPECT_EQ(among.size(), 100 * alone.size());
  for (const auto& [name, digest] : alone) EXPECT_EQ(among.at(name), digest) << name;
  EXPECT_NE(among.at("robot1/@truth"), among.at("robot0/@truth"));
}

/// A folder with a copy of an experiment to change.
class ChangedExperiment : public FolderTest {
 protected:
  ChangedExperiment() { fs::copy(kExperiments / "nimrod", folder_); }

  void append(const char* file, std::string_view text) {
    EXPECT_TRUE(write_file(folder_ / file, *read_file(folder_ / file) + std::string(text)));
  }
  Digests run_for(const char* duration_s) {
    return components(
        result_of(prepared(folder_, {set("run.duration_s", duration_s), set("run.free_ground", "false")}), 1));
  }
};

TEST_F(ChangedExperiment, LeavesTheBitsOfWhatTheNewComponentsHaveNothingToDoWith) {
  const Digests before = run_for("60");
  append("controller.toml", R"(
[[sensation]]
id = "behind"
channel = "sonar_back.range"

[[sensing]]
id = "approach"
kind = "ClosingSpeed"
in.range = "behind"
)");
  append("robot.toml", R"(
[[sensor]]
id = "sonar_back"
kind = "Sonar"
x_m = -0.12
yaw_deg = 180
)");
  const Digests after = run_for("60");
  EXPECT_EQ(after.size(), before.size() + 2);
  for (const auto& [name, digest] : before) EXPECT_EQ(after.at(name), digest) << name;
}

}  // namespace
}  // namespace ganglion
