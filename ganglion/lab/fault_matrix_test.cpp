#include "ganglion/lab/fault_matrix.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace ganglion::lab {
namespace {

namespace fs = std::filesystem;

const fs::path kNimrod = fs::path(GANGLION_SOURCE_DIR) / "experiments" / "nimrod";

Prepared nimrod(double duration_s) {
  Problems problems;
  auto prepared = prepare(kNimrod, {{"run.duration_s", std::to_string(duration_s)}}, problems);
  EXPECT_TRUE(prepared) << problems.text();
  return std::move(*prepared);
}

std::vector<std::string> names_of(const std::vector<FaultCase>& cases) {
  std::vector<std::string> names;
  for (const FaultCase& one : cases) names.push_back(one.name);
  return names;
}

TEST(FaultCases, AreEveryFaultOfWhatTheControllerUses) {
  const auto names = names_of(*fault_cases(nimrod(1), false));
  const std::vector<std::string> expected = {"healthy",
                                             "sonar_left dead",
                                             "sonar_left stuck",
                                             "sonar_left.range biased 0.1",
                                             "sonar_left.range noisy 0.05",
                                             "sonar_left late 0.5",
                                             "sonar_right dead",
                                             "sonar_right stuck",
                                             "sonar_right.range biased 0.1",
                                             "sonar_right.range noisy 0.05",
                                             "sonar_right late 0.5",
                                             "compass dead",
                                             "compass stuck",
                                             "compass.heading biased 0.349",  // 20 deg
                                             "compass.heading noisy 0.175",
                                             "compass late 0.5",
                                             "sonar_left.range swapped with sonar_right.range",
                                             "drive.left weak 0.5",
                                             "drive.right weak 0.5",
                                             "frames lost 0.2",
                                             "frames late 0.2",
                                             "commands lost 0.2",
                                             "commands late 0.2"};
  EXPECT_EQ(names, expected);  // neither the bumper nor the raw compass, which no behaviour reads
}

TEST(FaultCases, PairFaultsOfDifferentSignals) {
  const auto names = names_of(*fault_cases(nimrod(1), true));
  EXPECT_TRUE(std::ranges::count(names, "sonar_left dead + sonar_right dead"));
  EXPECT_TRUE(std::ranges::count(names, "drive.left weak 0.5 + drive.right weak 0.5"));
  EXPECT_FALSE(std::ranges::count(names, "sonar_left dead + sonar_left stuck"));
  EXPECT_FALSE(std::ranges::count(names, "sonar_left dead + sonar_left.range biased 0.1"));
}

/// Only what it says of itself.
class Described final : public ApplicationModel {
 public:
  explicit Described(Description description) : description_(std::move(description)) {}
  const Description& description() const noexcept override { return description_; }
  Result<std::unique_ptr<Application>> make() const override {
    return fail(ErrorCode::Unsupported, {"it only is described", "solo está descrito"});
  }

 private:
  Description description_;
};

TEST(FaultCases, OfVeryManySensorsAreRefused) {
  // 60 sonars have 300 faults of their own and 1770 swaps: hundreds of thousands of pairs.
  Prepared prepared = nimrod(1);
  Description description = prepared.application->description();
  const SensationChannel sonar = description.sensations.front();
  for (int n = 0; n < 60; ++n) {
    description.sensations.push_back(sonar);
    description.sensations.back().name = fmt::format("more_{}.range", n);
    prepared.controller.components.push_back({.id = {}, .channel = fmt::format("more_{}.range", n)});
  }
  prepared.application = std::make_shared<const Described>(std::move(description));
  EXPECT_TRUE(fault_cases(prepared, false));
  const auto pairs = run_fault_matrix(prepared, {}, {}, true);
  ASSERT_FALSE(pairs);
  EXPECT_EQ(pairs.error().code, ErrorCode::TooLarge);
  EXPECT_NE(pairs.error().what.en.find("more than 20000 cases in pairs: try them one by one (--faults matrix)"),
            std::string::npos)
      << pairs.error().what.en;
}

TEST(FaultMatrix, CountsWhatEachCriterionOfSuccessSays) {
  Prepared prepared = nimrod(1);
  prepared.experiment.success = {*parse_criterion("duration_s >= 1"), *parse_criterion("travelled_m > 100")};
  const auto rows = run_fault_matrix(prepared, each_seed({}, 2), {}, false);
  ASSERT_TRUE(rows) << rows.error().text();
  ASSERT_EQ(rows->size(), 23u);
  EXPECT_EQ((*rows)[1].name, "sonar_left dead");
  EXPECT_EQ((*rows)[1].runs, 2u);
  EXPECT_EQ((*rows)[1].succeeded, 0u);
  EXPECT_EQ((*rows)[1].met[0], (std::pair<std::string, std::size_t>("duration_s >= 1", 2)));
  EXPECT_EQ((*rows)[1].met[1].second, 0u);
}

TEST(NimrodWithBothSonarsDead, StandsStillWithinHalfASecond) {
  const auto way_m = [](std::uint64_t seed, double duration_s) {
    Prepared prepared = nimrod(duration_s);
    for (const char* sonar : {"sonar_left", "sonar_right"}) {
      Fault dead;
      dead.target = sonar;
      dead.from_s = 5;
      prepared.experiment.faults.push_back(dead);
    }
    RunOptions options;
    options.seed = seed;
    const auto result = run(prepared, options);
    EXPECT_TRUE(result) << result.error().text();
    return measure(result->measures, "travelled_m");
  };
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EXPECT_GT(way_m(seed, 5), 0.1) << "seed " << seed;
    EXPECT_NEAR(way_m(seed, 30), way_m(seed, 5.5), 1e-6) << "seed " << seed;
  }
}

TEST(NimrodsTrial, PassesTheBoxWithTheHeldCourseAndSwingsBeforeItWithout) {
  const auto progress_m = [](const std::vector<config::Override>& overrides, std::uint64_t seed) {
    Problems problems;
    const auto prepared = prepare(kNimrod / "box.toml", overrides, problems);
    EXPECT_TRUE(prepared) << problems.text();
    RunOptions options;
    options.seed = seed;
    const auto result = run(*prepared, options);
    EXPECT_TRUE(result) << result.error().text();
    return measure(result->measures, "progress_m");
  };
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    EXPECT_GE(progress_m({}, seed), 8) << "seed " << seed;
    EXPECT_LT(progress_m({{"controller.acting.hold.hold_s", "0"}, {"controller.acting.hold.hold_growth", "0"}}, seed),
              2.75)  // where the box begins
        << "seed " << seed;
  }
}

/// The problems of Nimrod's experiment with this text behind it.
std::string problems_with(const std::string& text, const std::vector<config::Override>& overrides = {}) {
  const fs::path file = kNimrod / "experiment.toml";
  std::ifstream in(file);
  std::string all{std::istreambuf_iterator<char>(in), {}};
  const fs::path folder = fs::path(testing::TempDir()) / fmt::format("ganglion_faults_{}", ::getpid());
  fs::create_directories(folder);
  for (const char* name : {"controller.toml", "robot.toml", "office.toml"})
    fs::copy_file(kNimrod / name, folder / name, fs::copy_options::overwrite_existing);
  std::ofstream(folder / "experiment.toml") << all << text;
  Problems problems;
  prepare(folder, overrides, problems);
  fs::remove_all(folder);
  std::string said = problems.text();
  for (std::size_t at; (at = said.find(folder.string() + "/")) != std::string::npos;)
    said.erase(at, folder.string().size() + 1);
  return said.substr(0, said.find('\n'));
}

std::string after_place(const std::string& text) { return text.substr(text.find(": ") + 2); }

TEST(FaultFile, WithTooManyFaultsIsRefused) {
  std::string faults;
  for (int n = 0; n < 64; ++n) faults += "[[fault]]\ntarget = \"compass\"\nkind = \"stuck\"\n";
  EXPECT_EQ(problems_with(faults), "");
  EXPECT_EQ(after_place(problems_with(faults + "[[fault]]\ntarget = \"compass\"\nkind = \"stuck\"\n")),
            "there are 65 faults; the limit is 64");
}

TEST(FaultFile, WithTooMuchToRememberIsRefused) {
  // A frame has 6 values: 20 s at 0.1 s are 200 ticks * 6 * 8 bytes * 10,000 robots = 92 MiB. Three are over 256.
  const std::string late = "[[fault]]\ntarget = \"frames\"\nkind = \"late\"\namount = 20\n";
  const std::vector<config::Override> army = {{"application.robots", "10000"}};
  EXPECT_EQ(problems_with(late + late, army), "");
  const std::string said = problems_with(late + late + late, army);
  EXPECT_TRUE(said.starts_with("experiment.toml:")) << said;
  EXPECT_NE(said.find("the limit is 256: take shorter delays, fewer faults or fewer robots"), std::string::npos)
      << said;
}

TEST(FaultFile, IsReadAndItsSlipsAreLocated) {
  EXPECT_EQ(problems_with("[[fault]]\ntarget = \"compass\"\nkind = \"stuck\"\nfrom_s = [1, 2]\nto_s = 9\n"), "");
  EXPECT_EQ(after_place(problems_with("[[fault]]\ntarget = \"compas\"\nkind = \"stuck\"\n")),
            "\"compas\" is no sensor, channel or command of the robot; did you mean \"compass\"?");
  EXPECT_EQ(after_place(problems_with("[[fault]]\ntarget = \"compass\"\nkind = \"lost\"\n")),
            "amount is a probability, must be > 0 and at most 1");
  EXPECT_NE(problems_with("[[fault]]\ntarget = \"compass\"\n").find("kind is missing: one of dead, stuck, biased"),
            std::string::npos);
  EXPECT_NE(problems_with("[[fault]]\ntarget = \"compass\"\nkind = \"stuck\"\nfrom_s = [2, 1]\n").find("smaller"),
            std::string::npos);
  EXPECT_NE(problems_with("[[fault]]\ntarget = \"compass\"\nkind = \"stuck\"\nfrom_s = 3\nto_s = 2\n")
                .find("to_s is not after"),
            std::string::npos);
}

}  // namespace
}  // namespace ganglion::lab
