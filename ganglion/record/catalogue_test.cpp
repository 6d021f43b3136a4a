#include "ganglion/record/catalogue.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <cmath>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/record/run_recorder.h"

namespace ganglion {
namespace {

RunSummary run(std::string file, std::uint64_t seed, Verdict verdict,
               std::vector<std::pair<std::string, double>> measures) {
  RunSummary summary;
  summary.file = std::move(file);
  summary.name = "Nimrod";
  summary.seed = seed;
  summary.controller_hash = "c0";
  summary.finished = true;
  summary.digest = "d" + std::to_string(seed);
  summary.verdict = verdict;
  summary.reason =
      verdict == Verdict::Succeeded ? Sentence{"goal", "meta"} : Sentence{"time is up", "se acabó el tiempo"};
  summary.measures = std::move(measures);
  summary.recorded_s = 1000 + static_cast<std::int64_t>(seed);
  return summary;
}

class Catalogue : public FolderTest {
 protected:
  RunCatalogue open() const {
    auto catalogue = RunCatalogue::open(folder_);
    EXPECT_TRUE(catalogue) << catalogue.error().text();
    return std::move(*catalogue);
  }
  static std::string files(const Result<std::vector<RunSummary>>& runs) {
    std::string all;
    for (const RunSummary& one : *runs) all += one.file + " ";
    return all;
  }
};

TEST_F(Catalogue, KeepsWhatWasAdded) {
  const std::uint64_t large_seed = 18446744073709551615u;
  ASSERT_TRUE(
      open().add(run("a.mcap", large_seed, Verdict::Succeeded, {{"time_s", 12.5}, {"area", NAN}, {"gap", INFINITY}})));
  const auto runs = open().list();
  ASSERT_TRUE(runs);
  ASSERT_EQ(runs->size(), 1u);
  const RunSummary& got = runs->front();
  EXPECT_EQ(got.seed, large_seed);
  EXPECT_EQ(got.digest, "d18446744073709551615");
  EXPECT_EQ(got.reason, (Sentence{"goal", "meta"}));
  EXPECT_EQ(got.verdict, Verdict::Succeeded);
  EXPECT_TRUE(got.finished);
  ASSERT_EQ(got.measures.size(), 3u);
  EXPECT_EQ(got.measures[0], (std::pair<std::string, double>("time_s", 12.5)));
  EXPECT_TRUE(std::isnan(got.measures[1].second));
  EXPECT_EQ(got.measures[2].second, INFINITY);
}

TEST_F(Catalogue, ReplacesTheRunOfTheSameFile) {
  auto catalogue = open();
  ASSERT_TRUE(catalogue.add(run("a.mcap", 1, Verdict::Failed, {{"time_s", 1}, {"area", 2}})));
  ASSERT_TRUE(catalogue.add(run("a.mcap", 2, Verdict::Succeeded, {{"time_s", 3}})));
  const auto runs = catalogue.list();
  ASSERT_EQ(runs->size(), 1u);
  EXPECT_EQ(runs->front().seed, 2u);
  EXPECT_EQ(runs->front().measures.size(), 1u);
}

TEST_F(Catalogue, FiltersAndSorts) {
  auto catalogue = open();
  ASSERT_TRUE(catalogue.add(run("a.mcap", 1, Verdict::Succeeded, {{"time_s", 30}})));
  ASSERT_TRUE(catalogue.add(run("b.mcap", 2, Verdict::Failed, {})));
  ASSERT_TRUE(catalogue.add(run("c.mcap", 3, Verdict::Succeeded, {{"time_s", 10}})));
  EXPECT_EQ(files(catalogue.list()), "c.mcap b.mcap a.mcap ");  // newest first
  EXPECT_EQ(files(catalogue.list({.success = true, .sort_by = "time_s", .descending = false})), "c.mcap a.mcap ");
  EXPECT_EQ(files(catalogue.list({.sort_by = "time_s"})), "a.mcap c.mcap b.mcap ");
  EXPECT_EQ(files(catalogue.list({.sort_by = "time_s", .descending = false})), "c.mcap a.mcap b.mcap ");
  EXPECT_EQ(files(catalogue.list({.seed = 2})), "b.mcap ");
  EXPECT_EQ(files(catalogue.list({.name = "Carlitos"})), "");
  EXPECT_EQ(files(catalogue.list({.controller_hash = "c0", .sort_by = "seed", .descending = false, .limit = 2})),
            "a.mcap b.mcap ");
}

TEST_F(Catalogue, KeepsRunsThatNobodyJudgedApart) {
  auto catalogue = open();
  ASSERT_TRUE(catalogue.add(run("a.mcap", 1, Verdict::NotJudged, {})));
  ASSERT_TRUE(catalogue.add(run("b.mcap", 2, Verdict::Failed, {})));
  ASSERT_TRUE(catalogue.add(run("c.mcap", 3, Verdict::Succeeded, {})));
  EXPECT_EQ(files(catalogue.list({.success = true})), "c.mcap ");
  EXPECT_EQ(files(catalogue.list({.success = false})), "b.mcap ");
  const auto runs = catalogue.list({.sort_by = "success", .descending = false});
  ASSERT_EQ(files(runs), "a.mcap b.mcap c.mcap ");
  EXPECT_EQ(runs->front().verdict, Verdict::NotJudged);
}

TEST_F(Catalogue, SuggestsWhatToSortBy) {
  ASSERT_TRUE(open().add(run("a.mcap", 1, Verdict::Succeeded, {{"time_s", 30}})));
  const auto refused = open().list({.sort_by = "time"});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::UnknownKey);
  EXPECT_NE(refused.error().what.en.find("\"time\"; did you mean"), std::string::npos) << refused.error().what.en;
  EXPECT_FALSE(open().list({.sort_by = "seed; DROP TABLE run"}));
}

TEST_F(Catalogue, IsRebuiltFromTheFiles) {
  const RunInfo info{.name = "Nimrod", .seed = 7, .episode = 1, .tick_s = 0.1, .controller_hash = "c0"};
  ASSERT_TRUE(RunRecorder::create(folder_ / "2020" / "done.mcap", info)
                  ->finish({.digest = "d7",
                            .verdict = Verdict::Succeeded,
                            .reason = {"goal", "meta"},
                            .measures = {{"time_s", 3}}}));
  ASSERT_TRUE(RunRecorder::create(folder_ / "whole.mcap", info)->finish({}));
  const std::string whole = *read_file(folder_ / "whole.mcap");
  std::filesystem::remove(folder_ / "whole.mcap");
  ASSERT_TRUE(write_file(folder_ / "cut.mcap", whole.substr(0, whole.find("ganglion.outcome"))));
  ASSERT_TRUE(write_file(folder_ / "broken.mcap", "no run at all"));
  auto catalogue = open();
  ASSERT_TRUE(catalogue.add(run("gone.mcap", 1, Verdict::Succeeded, {})));
  const auto report = catalogue.rebuild();
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_EQ(report->runs, 2u);
  ASSERT_EQ(report->problems.size(), 1u);
  EXPECT_NE(report->problems[0].text().find("broken.mcap: is no MCAP file"), std::string::npos);
  const auto runs = catalogue.list({.sort_by = "file", .descending = false});
  ASSERT_EQ(files(runs), "2020/done.mcap cut.mcap ");
  EXPECT_EQ((*runs)[0].digest, "d7");
  EXPECT_EQ((*runs)[0].reason.es, "meta");
  EXPECT_EQ((*runs)[0].measures.size(), 1u);
  EXPECT_GT((*runs)[0].recorded_s, 1'500'000'000);
  EXPECT_FALSE((*runs)[1].finished);
  EXPECT_EQ((*runs)[1].seed, 7u);
}

TEST_F(Catalogue, ThatIsDamagedIsBuiltAnewFromTheFiles) {
  const RunInfo info{.name = "Nimrod", .seed = 7, .tick_s = 0.1, .controller_hash = "c0"};
  ASSERT_TRUE(RunRecorder::create(folder_ / "done.mcap", info)->finish({.digest = "d7"}));
  const auto add = [this] { return open().add(run("gone.mcap", 1, Verdict::Succeeded, {})); };
  const std::filesystem::path file = folder_ / "catalogue.sqlite";
  ASSERT_TRUE(add());
  const std::string good = *read_file(file);
  std::string torn = good;
  torn.replace(good.size() / 2, 100, 100, 'x');
  for (const std::string& bad : {std::string("no database"), torn, good.substr(0, good.size() / 2)}) {
    ASSERT_TRUE(write_file(file, bad));
    EXPECT_EQ(files(open().list({.sort_by = "file", .descending = false})), "done.mcap ");
    EXPECT_TRUE(std::filesystem::exists(folder_ / "catalogue.damaged.sqlite"));
    ASSERT_TRUE(add()) << "as ever";
    EXPECT_EQ(files(open().list({.sort_by = "file", .descending = false})), "done.mcap gone.mcap ");
  }
}

TEST_F(Catalogue, OfAnotherProgramOrBehindALinkIsLeftAlone) {
  const std::filesystem::path file = folder_ / "catalogue.sqlite", elsewhere = folder_ / "elsewhere.sqlite";
  sqlite3* other = nullptr;
  ASSERT_EQ(sqlite3_open(elsewhere.c_str(), &other), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(other, "CREATE TABLE music(song)", nullptr, nullptr, nullptr), SQLITE_OK);
  ASSERT_EQ(sqlite3_close(other), SQLITE_OK);
  const std::string bytes = *read_file(elsewhere);
  std::filesystem::copy_file(elsewhere, file);
  EXPECT_EQ(RunCatalogue::open(folder_).error().code, ErrorCode::Unsupported);
  EXPECT_EQ(*read_file(file), bytes);
  std::filesystem::remove(file);
  std::filesystem::remove(elsewhere);
  std::filesystem::create_symlink(elsewhere, file);
  EXPECT_EQ(RunCatalogue::open(folder_).error().code, ErrorCode::Unsupported);
  EXPECT_FALSE(std::filesystem::exists(elsewhere));
}

TEST(CatalogueCsv, HasAColumnForEveryMeasure) {
  const std::vector<RunSummary> runs = {run("a,1.mcap", 1, Verdict::Succeeded, {{"time_s", 30}}),
                                        run("b.mcap", 2, Verdict::Failed, {{"area", NAN}}),
                                        run("c.mcap", 3, Verdict::NotJudged, {})};
  EXPECT_EQ(to_csv(runs),
            "file,name,seed,episode,controller_hash,finished,digest,success,reason,recorded_s,area,time_s\n"
            "\"a,1.mcap\",Nimrod,1,0,c0,true,d1,true,goal,1001,,30\n"
            "b.mcap,Nimrod,2,0,c0,true,d2,false,time is up,1002,nan,\n"
            "c.mcap,Nimrod,3,0,c0,true,d3,,time is up,1003,,\n");
}

}  // namespace
}  // namespace ganglion
