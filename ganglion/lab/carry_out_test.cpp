#include "ganglion/lab/carry_out.h"

#include <gtest/gtest.h>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/record/catalogue.h"
#include "ganglion/record/run_file.h"

// What is left of a run that is carried out, and what is told of what is not.
namespace ganglion::lab {
namespace {

namespace fs = std::filesystem;

class CarryOut : public FolderTest {
 protected:
  static Prepared second(const std::string& experiment) {
    Problems problems;
    auto made = prepare(fs::path(GANGLION_SOURCE_DIR) / "experiments" / experiment,
                        {{"run.duration_s", "1"}, {"run.free_ground", "false"}}, problems);
    EXPECT_EQ(problems.text(), "");
    return made.value();
  }
  const Job job_{.experiment = "nimrod", .overrides = {}, .seed = 3, .faults = {}};
};

TEST_F(CarryOut, LeavesRunFileReportAndALineInTheCatalogue) {
  const Prepared nimrod = second("nimrod");
  Keep keep;
  keep.run_file = folder_ / "seed_0003.mcap";
  bool ended = false;
  Hooks hooks;
  hooks.ended = [&](const Result<RunResult>& result) {
    ended = result.has_value() && !fs::exists(folder_ / "seed_0003.html");
  };
  const Outcome outcome = carry_out(nimrod, job_, keep, hooks).value();
  EXPECT_TRUE(ended) << "before anything is made of the file";
  EXPECT_TRUE(outcome.troubles.empty());
  const std::vector<std::string> files = {keep.run_file.string(), (folder_ / "seed_0003.html").string()};
  EXPECT_EQ(outcome.files, files);
  EXPECT_EQ(outcome.digest, run(nimrod, {.seed = 3})->digest);
  const auto listed = RunCatalogue::open(folder_)->list({}).value();
  ASSERT_EQ(listed.size(), 1u);
  EXPECT_EQ(listed[0].file, "seed_0003.mcap");
  EXPECT_EQ(listed[0].digest, outcome.digest);
}

TEST_F(CarryOut, KeepsNothingUnlessAsked) {
  const Outcome outcome = carry_out(second("nimrod"), job_, {}).value();
  EXPECT_TRUE(outcome.files.empty());
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(CarryOut, TellsWhatCouldNotBeKept) {
  Keep keep;
  keep.run_file = folder_ / "seed_0003.mcap";
  ASSERT_TRUE(write_file(folder_ / "seed_0003.html" / "in_the_way", ""));  // a folder where the page shall be
  ASSERT_TRUE(write_file(folder_ / "catalogue.sqlite" / "in_the_way", ""));
  const Outcome outcome = carry_out(second("nimrod"), job_, keep).value();
  EXPECT_EQ(outcome.files.size(), 1u);
  ASSERT_NE(outcome.trouble(Trouble::Of::Files), nullptr);
  EXPECT_EQ(outcome.trouble(Trouble::Of::Files)->code, ErrorCode::Unwritable);
  EXPECT_NE(outcome.trouble(Trouble::Of::Catalogue), nullptr);
  EXPECT_EQ(outcome.trouble(Trouble::Of::Link), nullptr);
}

TEST_F(CarryOut, FailsWhereTheFileCannotBeMade) {
  Keep keep;
  ASSERT_TRUE(write_file(folder_ / "no_folder", ""));
  keep.run_file = folder_ / "no_folder" / "seed_0003.mcap";
  EXPECT_FALSE(carry_out(second("nimrod"), job_, keep));
}

TEST_F(CarryOut, AddsToWhatTheExperienceRemembers) {
  Keep keep;
  keep.experience = folder_ / "memory.sqlite";
  const Prepared pathfinder = second("pathfinder");
  EXPECT_TRUE(carry_out(pathfinder, job_, keep).value().troubles.empty());
  EXPECT_TRUE(fs::exists(keep.experience));
  ASSERT_TRUE(write_file(folder_ / "torn.sqlite", std::string(5000, 'x')));
  keep.experience = folder_ / "torn.sqlite";
  EXPECT_FALSE(carry_out(pathfinder, job_, keep));
}

TEST_F(CarryOut, PutsAJobsFaultsOnTopOfTheExperiments) {
  const Prepared nimrod = second("nimrod");
  Job faulty = job_;
  for (const char* sonar : {"sonar_left", "sonar_right"}) {
    faulty.faults.emplace_back();
    faulty.faults.back().target = sonar;  // dead
  }
  const Outcome outcome = carry_out(nimrod, faulty, {}).value();
  EXPECT_LT(measure(outcome.figures, "travelled_m"), 1e-9) << "blind, it stands still";
  EXPECT_GT(measure(carry_out(nimrod, job_, {})->figures, "travelled_m"), 0.01);
  EXPECT_TRUE(nimrod.experiment.faults.empty());
}

}  // namespace
}  // namespace ganglion::lab
