#include "ganglion/lab/batch.h"

#include <gtest/gtest.h>

// Many runs together give each what it gives alone, whatever thread did it.
namespace ganglion::lab {
namespace {

Prepared nimrod(double duration_s) {
  Problems problems;
  auto made = prepare(GANGLION_SOURCE_DIR "/experiments/nimrod",
                      {{"run.duration_s", std::to_string(duration_s)}, {"run.free_ground", "false"}}, problems);
  EXPECT_EQ(problems.text(), "");
  return made.value();
}

std::vector<std::string> digests(const Prepared& prepared, std::uint64_t last_seed, int threads) {
  BatchOptions options;
  options.threads = threads;
  std::vector<std::string> list;
  const auto batch = carry_out_all(prepared, each_seed({}, last_seed), options);
  for (const Outcome& outcome : batch.value()) list.push_back(outcome.digest);
  return list;
}

TEST(Batch, GivesTheSameBitsOnOneThreadAndOnTwo) {
  const Prepared office = nimrod(20);
  const auto one = digests(office, 6, 1);
  EXPECT_EQ(one, digests(office, 6, 2));
  EXPECT_NE(one[0], one[1]);
}

TEST(Batch, GivesTheSameBitsForAnHour) {
  const Prepared office = nimrod(3600);
  const auto together = digests(office, 2, 2);
  EXPECT_EQ(together[1], run(office, {.seed = 2})->digest);
}

TEST(Batch, TellsJobsInTheirOrderAndStopsWhereItIsTold) {
  const Prepared office = nimrod(1);
  BatchOptions options;
  options.threads = 1;
  options.progress = [](std::size_t done, std::size_t all) {
    EXPECT_EQ(all, 4u);
    return done < 2;
  };
  const auto jobs = each_seed({.experiment = "nimrod", .overrides = {}, .seed = 7, .faults = {}}, 10);
  const auto outcomes = carry_out_all(office, jobs, options);
  ASSERT_EQ(outcomes->size(), 2u);
  EXPECT_EQ((*outcomes)[0].job.seed, 7u);
  EXPECT_EQ((*outcomes)[1].job.seed, 8u);
  EXPECT_EQ((*outcomes)[1].job.experiment, "nimrod");
}

TEST(Batch, SumsUpMeasuresInQuartiles) {
  std::vector<Outcome> outcomes(3);
  for (std::size_t i = 0; i < 3; ++i) outcomes[i].figures = {{"way_m", 10.0 * static_cast<double>(i + 1)}};
  const auto summary = quartiles(outcomes);
  ASSERT_EQ(summary.size(), 1u);
  EXPECT_EQ(summary[0].median, 20);
  EXPECT_EQ(summary[0].lower, 15);
  EXPECT_EQ(summary[0].upper, 25);
}

}  // namespace
}  // namespace ganglion::lab
