#include <gtest/gtest.h>

#include <cmath>

#include "ganglion/base/base64.h"
#include "ganglion/plot/testing/markup.h"
#include "ganglion/report/comparison.h"
#include "ganglion/report/field_states.h"
#include "ganglion/report/html.h"
#include "ganglion/report/packed.h"

namespace ganglion::report {
namespace {

TEST(Packed, PutsTheLowByteFirst) {
  EXPECT_EQ(pack_u32(std::vector<std::uint32_t>{0x04030201}), base64(std::vector<std::uint8_t>{1, 2, 3, 4}));
  EXPECT_EQ(pack_u16(std::vector<std::uint16_t>{0x0201}), base64(std::vector<std::uint8_t>{1, 2}));
  EXPECT_EQ(pack_f32(std::vector<double>{1}), base64(std::vector<std::uint8_t>{0, 0, 0x80, 0x3f}));  // IEEE 754: 1.0f
}

shown::Exhibit field(Vector2 origin, std::vector<std::uint8_t> cells) {
  shown::Field one;
  one.frame = "world";
  one.origin = origin;
  one.columns = static_cast<int>(cells.size());
  one.rows = 1;
  one.layers.resize(1);
  one.cells = {std::move(cells)};
  return {{}, std::move(one)};
}

ExhibitTrack track_with(const std::vector<shown::Exhibit>& states) {
  ExhibitTrack track = *track_of("/robot0/exhibit/router/field/map");
  double time_s = 0;
  for (const shown::Exhibit& state : states) EXPECT_TRUE(track.add(time_s++, state));
  return track;
}

TEST(FieldStates, AreWhatDiffersFromTheStateBefore) {
  const FieldStates states = states_of(track_with({field({}, {10, 20}), field({}, {10, 30}), field({}, {10, 30})}));
  ASSERT_EQ(states.states.size(), 2u);  // the third is as the second
  EXPECT_EQ(std::get<shown::Field>(states.states[0].change).cells[0], (std::vector<std::uint8_t>{10, 20}));
  const auto& patch = std::get<shown::Patch>(states.states[1].change);
  EXPECT_EQ(patch.column, 1);
  EXPECT_EQ(patch.cells[0], (std::vector<std::uint8_t>{30}));
}

TEST(FieldStates, AreCutToWhatIsKnown) {
  const FieldStates states = states_of(track_with({field({1, 2}, {255, 255, 7, 255, 8, 255})}));
  const auto& cut = std::get<shown::Field>(states.states.at(0).change);
  EXPECT_EQ(cut.cells[0], (std::vector<std::uint8_t>{7, 255, 8}));
  EXPECT_EQ(cut.origin, (Vector2{3, 2}));
}

TEST(FieldStates, AreThinnedButEndAsTheFieldEnded) {
  std::vector<shown::Exhibit> all;
  for (int i = 1; i <= 101; ++i) all.push_back(field({}, {static_cast<std::uint8_t>(i)}));
  const FieldStates states = states_of(track_with(all), 20);
  EXPECT_LE(states.states.size(), 21u);
  EXPECT_EQ(std::get<shown::Patch>(states.states.back().change).cells[0][0], 101);
}

TEST(FieldStates, AreNoneOfAFieldOfNothing) {
  EXPECT_TRUE(states_of(track_with({})).states.empty());
  EXPECT_TRUE(states_of(track_with({field({}, {255, 255})})).states.empty());
  EXPECT_TRUE(states_of(track_with({field({}, {1, 2, 3})}), 10, 2).states.empty());  // too large
}

TEST(RunLengths, AreHowManyMoreThanOneAndWhich) {
  EXPECT_EQ(run_lengths({5, 5, 5, 9}), (std::vector<std::uint8_t>{2, 5, 0, 9}));
  EXPECT_EQ(run_lengths(std::vector<std::uint8_t>(257, 3)), (std::vector<std::uint8_t>{255, 3, 0, 3}));
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
