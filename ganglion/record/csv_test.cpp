#include "ganglion/record/csv.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ganglion/base/testing/folder.h"

namespace ganglion {
namespace {

class CsvTest : public FolderTest {};

TEST_F(CsvTest, SpellsMissingReadingsAndReadsThemBack) {
  const SignalTable table{.topic = "/robot0/signals",
                          .columns = {{"sonar", "m"}, {"a,\"b\"", ""}},
                          .ticks = {0, 1},
                          .times_s = {0, 0.1},
                          .values = {NAN, INFINITY, -INFINITY, 1.0 / 3}};
  EXPECT_EQ(to_csv(table),
            "tick,time_s,sonar,\"a,\"\"b\"\"\"\n"
            "0,0,nan,inf\n"
            "1,0.1,-inf,0.3333333333333333\n");
  ASSERT_TRUE(write_csv(table, folder_ / "a.csv"));
  const auto csv = read_csv(folder_ / "a.csv");
  ASSERT_TRUE(csv) << csv.error().text();
  EXPECT_EQ(csv->columns, (std::vector<std::string>{"tick", "time_s", "sonar", "a,\"b\""}));
  ASSERT_EQ(csv->rows(), 2u);
  EXPECT_TRUE(std::isnan(csv->at(0, *csv->column("sonar"))));
  EXPECT_EQ(csv->at(1, *csv->column("sonar")), -INFINITY);
  EXPECT_EQ(csv->at(1, 3), 1.0 / 3);
  EXPECT_FALSE(csv->column("cost"));
}

TEST(Csv, TakesWhatSpreadsheetsWrite) {
  const auto csv = parse_csv("\xef\xbb\xbf\"time_s\", cost\r\n 0 ,1\r\n+0.5,\"2e3\"\r\n\r\n", "a.csv");
  ASSERT_TRUE(csv) << csv.error().text();
  EXPECT_EQ(csv->columns, (std::vector<std::string>{"time_s", "cost"}));
  EXPECT_EQ(csv->values, (std::vector<double>{0, 1, 0.5, 2000}));
}

TEST(Csv, SaysWhereItIsWrong) {
  const auto where = [](std::string_view text) { return parse_csv(text, "a.csv").error().text(); };
  EXPECT_EQ(where("time_s,x\n0,1\n1,2m\n"), "a.csv:3:3: x: \"2m\" is no number; valid: decimals, nan, inf, -inf");
  EXPECT_EQ(where("time_s,x\n0\n"), "a.csv:2:1: 1 cells, where 2 columns are named on line 1");
  EXPECT_EQ(where("time_s,x,x\n"), "a.csv:1:10: column \"x\" is there twice");
  EXPECT_EQ(where("time_s,\n"), "a.csv:1:8: the first line must name every column");
  EXPECT_EQ(where(""), "a.csv:1:1: the first line must name every column");
  EXPECT_EQ(where("\"time_s\n0"), "a.csv:1:1: a quote is not closed on its line");
}

TEST(Csv, TakesInfinityAsJsonSpellsIt) {
  const auto csv = parse_csv("time_s,x,y\n0,Infinity,-Infinity\n1,+Infinity,NaN\n", "a.csv");
  ASSERT_TRUE(csv) << csv.error().text();
  EXPECT_EQ(csv->at(0, 1), INFINITY);
  EXPECT_EQ(csv->at(0, 2), -INFINITY);
  EXPECT_EQ(csv->at(1, 1), INFINITY);
}

TEST(Csv, SaysThatItWantsCommas) {
  const auto said = [](std::string_view text) { return parse_csv(text, "a.csv").error().text(); };
  EXPECT_EQ(said("time_s;x\n0;1\n"),
            "a.csv:1:7: columns are separated by semicolons here; write commas between them, and points in numbers");
  EXPECT_EQ(said("time_s;x\n0,1;2\n").substr(0, 51), "a.csv:1:7: columns are separated by semicolons here");
  EXPECT_NE(said("time_s\tx\n0\t1\n").find("separated by tabs"), std::string::npos);
}

TEST(Csv, LimitsItsColumns) {
  std::string names = "a0";
  for (std::size_t i = 1; i <= kMaxCsvColumns; ++i) names += ",a" + std::to_string(i);
  EXPECT_EQ(parse_csv(names, "a.csv").error().code, ErrorCode::TooLarge);
}

TEST(Csv, SurvivesMutations) {
  const std::string good = "time_s,\"a\"\"b\",c\n0,1,2\n0.5,nan,-inf\n1,2e-3,4\n";
  std::mt19937_64 random(1);
  std::size_t read = 0;
  for (int round = 0; round < 5000; ++round) {
    std::string text = good;
    for (std::size_t i = 0; i <= random() % 3; ++i) text[random() % text.size()] = static_cast<char>(random());
    if (const auto csv = parse_csv(text, "a.csv")) read += csv->rows();
  }
  EXPECT_GT(read, 0u);
}

}  // namespace
}  // namespace ganglion
