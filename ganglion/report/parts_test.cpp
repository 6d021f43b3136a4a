#include <gtest/gtest.h>

#include <cmath>

#include "ganglion/base/base64.h"
#include "ganglion/plot/testing/markup.h"
#include "ganglion/report/comparison.h"
#include "ganglion/report/html.h"
#include "ganglion/report/map_changes.h"
#include "ganglion/report/packed.h"

namespace ganglion::report {
namespace {

TEST(Packed, PutsTheLowByteFirst) {
  EXPECT_EQ(pack_u32(std::vector<std::uint32_t>{0x04030201}), base64(std::vector<std::uint8_t>{1, 2, 3, 4}));
  EXPECT_EQ(pack_u16(std::vector<std::uint16_t>{0x0201}), base64(std::vector<std::uint8_t>{1, 2}));
  EXPECT_EQ(pack_f32(std::vector<double>{1}), base64(std::vector<std::uint8_t>{0, 0, 0x80, 0x3f}));  // IEEE 754: 1.0f
}

plot::MapFrame frame(double time_s, Vector2 origin, int columns, std::vector<std::uint8_t> risk) {
  plot::MapFrame result{time_s, origin, columns, 1, std::vector<std::uint8_t>(risk.size(), 1), risk, {}, {}};
  return result;
}

TEST(MapChanges, AreWhatDiffersFromTheFrameBefore) {
  const plot::MapView map{
      "router", 0.5, {frame(0, {0, 0}, 2, {10, 20}), frame(1, {0, 0}, 2, {10, 30}), frame(2, {0, 0}, 2, {10, 30})}};
  const MapChanges changes = changes_of(map);
  EXPECT_EQ(changes.columns, 2);
  ASSERT_EQ(changes.frames.size(), 2u);  // the third frame is as the second
  EXPECT_EQ(changes.frames[0].changes, (std::vector<std::uint32_t>{0, 10 | 1 << 16, 1, 20 | 1 << 16}));
  EXPECT_EQ(changes.frames[1].changes, (std::vector<std::uint32_t>{1, 30 | 1 << 16}));
}

TEST(MapChanges, CoverAMapThatGrewToTheLeft) {
  const plot::MapView map{"router", 0.5, {frame(0, {0, 0}, 1, {10}), frame(1, {-1, 0}, 3, {5, 6, 10})}};
  const MapChanges changes = changes_of(map);
  EXPECT_EQ(changes.columns, 3);
  EXPECT_EQ(changes.origin, (Vector2{-1, 0}));
  EXPECT_EQ(changes.frames[0].changes, (std::vector<std::uint32_t>{2, 10 | 1 << 16}));
  EXPECT_EQ(changes.frames[1].changes, (std::vector<std::uint32_t>{0, 5 | 1 << 16, 1, 6 | 1 << 16}));
}

TEST(MapChanges, AreThinnedButEndAsTheMapEnded) {
  plot::MapView map{"router", 0.5, {}};
  for (int i = 1; i <= 101; ++i) map.frames.push_back(frame(i, {0, 0}, 1, {static_cast<std::uint8_t>(i)}));
  const MapChanges changes = changes_of(map, 20);
  EXPECT_LE(changes.frames.size(), 20u);
  EXPECT_EQ(changes.frames.back().changes[1] & 255, 101u);
}

TEST(MapChanges, AreNoneForAMapOfNothing) {
  EXPECT_TRUE(changes_of({"router", 0.5, {}}).frames.empty());
  plot::MapView far{"router", 0.5, {frame(0, {0, 0}, 1, {1}), frame(1, {1e9, 0}, 1, {1})}};
  EXPECT_TRUE(changes_of(far).frames.empty());  // too large a grid
}

TEST(Wilson, GivesThePublishedInterval) {
  // 8 of 10: 0.4902 to 0.9433 (R, binom.confint(8, 10, methods = "wilson")).
  EXPECT_NEAR(wilson(8, 10).lower, 0.4901625, 1e-6);
  EXPECT_NEAR(wilson(8, 10).upper, 0.9433178, 1e-6);
  EXPECT_EQ(wilson(0, 10).lower, 0);
  EXPECT_EQ(wilson(0, 0).upper, 1);
}

TEST(UnitOf, IsTheSuffixOfTheName) {
  EXPECT_EQ(unit_of("path_m"), "m");
  EXPECT_EQ(unit_of("mean_speed_mps"), "m/s");
  EXPECT_EQ(unit_of("energy_J"), "J");
  EXPECT_EQ(unit_of("contacts"), "");
  EXPECT_EQ(unit_of("goals_reached"), "");
}

TEST(Comparison, ShowsSharesAndQuartilesOfBothPresets) {
  NamedBatch listing{"listing", {}}, recommended{"<b>recommended</b>", {}};
  for (int i = 1; i <= 4; ++i) {
    listing.runs.push_back({i == 1 ? Verdict::Succeeded : Verdict::Failed, {{"path_m", i}}});
    recommended.runs.push_back({Verdict::Succeeded, {{"path_m", 10.0 * i}, {"contacts", NAN}}});
  }
  const std::vector<NamedBatch> batches{listing, recommended};
  const std::string html = comparison_page(batches);
  EXPECT_NE(html.find("<td class=\"number\">0.25</td>"), std::string::npos);  // share of the listing
  for (const char* quartile : {">1.75<", ">2.5<", ">3.25<", ">17.5<", ">25<", ">32.5<"})
    EXPECT_NE(html.find(quartile), std::string::npos) << quartile;
  EXPECT_EQ(html.find("<b>"), std::string::npos);
  EXPECT_NE(comparison_page(batches, plot::Language::Spanish).find("mediana"), std::string::npos);
}

TEST(Comparison, TakesTheShareOfTheRunsThatWereJudged) {
  NamedBatch batch{"free", {{Verdict::NotJudged, {}}, {Verdict::NotJudged, {}}}};
  const std::string dashes = "<td class=\"number\">2</td><td class=\"number\">-</td><td class=\"number\">-</td>";
  EXPECT_NE(comparison_page(std::vector{batch}).find(dashes), std::string::npos);
  batch.runs.push_back({Verdict::Succeeded, {}});
  batch.runs.push_back({Verdict::Failed, {}});
  EXPECT_EQ(successes_of(batch).judged, 2u);
  EXPECT_EQ(successes_of(batch).won, 1u);
  EXPECT_NE(comparison_page(std::vector{batch}).find("<td class=\"number\">0.5</td>"), std::string::npos);
}

}  // namespace
}  // namespace ganglion::report
