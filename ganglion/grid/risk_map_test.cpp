#include "ganglion/grid/risk_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ganglion/grid/price.h"

namespace ganglion::grid {
namespace {

constexpr double kExact = 1e-12;

Cell occupied(double risk, Nature nature) {
  Cell cell;
  cell.label = Label::Occupied;
  cell.nature = nature;
  cell.risk = risk;
  return cell;
}

TEST(RiskRule, CallsAnUnexploredCellThatCannotBeEnteredOccupiedAndStatic) {
  Cell cell;
  note_failure(cell, {});
  EXPECT_EQ(cell.label, Label::Occupied);
  EXPECT_EQ(cell.nature, Nature::Static);
  EXPECT_EQ(cell.risk, 0.2);
}

TEST(RiskRule, CallsACellDynamicThatWasCrossedAndNowBlocks) {
  Cell cell;
  note_crossing(cell, {});
  note_failure(cell, {});
  EXPECT_EQ(cell.label, Label::Occupied);
  EXPECT_EQ(cell.nature, Nature::Dynamic);
  EXPECT_EQ(cell.risk, 0.2);  // 0 + 0.15 is less than the least
}

TEST(RiskRule, RaisesTheRiskWithEachFailure) {
  Cell cell = occupied(0.2, Nature::Static);
  note_failure(cell, {});
  EXPECT_NEAR(cell.risk, 0.32, kExact);  // 0.2 + 0.15 * 0.8
  note_failure(cell, {});
  EXPECT_NEAR(cell.risk, 0.422, kExact);  // 0.32 + 0.15 * 0.68
  EXPECT_EQ(cell.nature, Nature::Static);
  for (int i = 0; i < 1000; ++i) note_failure(cell, {});
  EXPECT_LT(cell.risk, 1);
}

TEST(RiskRule, LowersTheRiskMuchWhenAStaticCellIsCrossedAndALittleWhenADynamicOneIs) {
  Cell once_static = occupied(0.5, Nature::Static);
  note_crossing(once_static, {});
  EXPECT_NEAR(once_static.risk, 0.15, kExact);
  EXPECT_EQ(once_static.label, Label::Empty);
  EXPECT_EQ(once_static.nature, Nature::Dynamic);
  note_crossing(once_static, {});
  EXPECT_NEAR(once_static.risk, 0.105, kExact);
}

TEST(RiskRule, GivesNoRiskToAnUnexploredCellThatWasEntered) {
  Cell cell;
  note_crossing(cell, {});
  EXPECT_EQ(cell.label, Label::Empty);
  EXPECT_EQ(cell.nature, Nature::Dynamic);
  EXPECT_EQ(cell.risk, 0);
}

TEST(RiskRule, InhibitsLongerWhereTheRiskIsHigher) {
  EXPECT_EQ(inhibition_ticks(0.0, {}), 2u);
  EXPECT_EQ(inhibition_ticks(0.2, {}), 5u);     // 2 + floor(3.6)
  EXPECT_EQ(inhibition_ticks(0.32, {}), 7u);    // 2 + floor(5.76)
  EXPECT_EQ(inhibition_ticks(0.999, {}), 19u);  // 2 + floor(17.98)
}

TEST(RiskRule, KeepsTheMeanOfWhatCrossingCosts) {
  Cell cell;
  for (const double cost_j : {2.0, 4.0, 9.0}) note_cost(cell, cost_j);
  EXPECT_NEAR(cell.cost_j, 5, kExact);
}

RiskMap map_round(CellIndex cell, int max_tiles = 8) {
  RiskMap map(max_tiles, {});
  map.grow_around(cell);
  return map;
}

TEST(RiskMap, ClosesACellForTheTicksOfItsInhibition) {
  RiskMap map = map_round({5, 5});
  map.fail({5, 5}, 100);
  EXPECT_TRUE(RiskMap::inhibited(*map.find({5, 5}), 100));
  EXPECT_TRUE(RiskMap::inhibited(*map.find({5, 5}), 104));
  EXPECT_FALSE(RiskMap::inhibited(*map.find({5, 5}), 105));
  EXPECT_EQ(map.next_lapse(100), 105u);
  EXPECT_EQ(map.next_lapse(105), std::nullopt);
}

TEST(RiskMap, GrowsOnlyWhereTheRobotIsAndUpToItsLimit) {
  RiskMap map(3, {});
  EXPECT_EQ(map.find({0, 0}), nullptr);
  map.grow_around({30, 30});
  EXPECT_EQ(map.tiles().size(), 1u);
  map.grow_around({62, 30});  // two steps from the next tile
  EXPECT_EQ(map.tiles().size(), 2u);
  EXPECT_NE(map.find({64, 0}), nullptr);
  map.grow_around({-1, -1});
  EXPECT_TRUE(map.full());
  EXPECT_NE(map.find({-1, -1}), nullptr);
  EXPECT_EQ(map.find({1000, 1000}), nullptr);
}

TEST(RiskMap, CountsWhatIsExploredAndOccupied) {
  RiskMap map = map_round({0, 0});
  map.cross({0, 0});
  map.cross({0, 0});
  map.fail({1, 0}, 1);
  map.fail({0, 0}, 1);
  EXPECT_EQ(map.explored(), 2);
  EXPECT_EQ(map.occupied(), 2);
  map.cross({1, 0});
  EXPECT_EQ(map.occupied(), 1);
}

TEST(RiskMap, GivesAStaticCellOneAttemptARoundAndADynamicOneThree) {
  RiskMap map = map_round({0, 0});
  map.fail({1, 0}, 1);
  EXPECT_TRUE(map.spent(*map.find({1, 0})));
  map.new_round();
  EXPECT_FALSE(map.spent(*map.find({1, 0})));
  map.cross({2, 0});
  map.fail({2, 0}, 1);
  map.fail({2, 0}, 1);
  EXPECT_FALSE(map.spent(*map.find({2, 0})));
  map.fail({2, 0}, 1);
  EXPECT_TRUE(map.spent(*map.find({2, 0})));
}

TEST(RiskMap, CountsAnAttemptHalfWhenNothingWasTouched) {
  RiskMap map = map_round({0, 0});
  map.fail({1, 1}, 1, FailureCause::Untouched);
  EXPECT_FALSE(map.spent(*map.find({1, 1})));
  map.fail({1, 1}, 1, FailureCause::Untouched);
  EXPECT_TRUE(map.spent(*map.find({1, 1})));
}

TEST(RiskMap, ClosesADiagonalForTheRoundWhenItsFailureIsUnclear) {
  RiskMap map = map_round({0, 0});
  map.fail({1, 1}, 1, FailureCause::Unclear);
  map.fail_diagonal({0, 0}, 1);
  EXPECT_FALSE(map.spent(*map.find({1, 1})));
  const Pricing later{map, {}, Query::Feasible, 100};
  EXPECT_FALSE(later.may_step({0, 0}, 1));
  EXPECT_TRUE(later.may_step({0, 0}, 7));
  EXPECT_TRUE(later.may_step({1, 0}, 2));  // the blamed cell may be tried from another side
  map.new_round();
  EXPECT_TRUE(later.may_step({0, 0}, 1));
}

TEST(RiskMap, WeighsACellByWhatItCostsBesideTheOthers) {
  RiskMap map = map_round({0, 0});
  map.book_cost({0, 0}, 1);
  map.book_cost({1, 0}, 1);
  map.book_cost({2, 0}, 4);  // mean of all: 2
  EXPECT_NEAR(map.cost_factor(*map.find({2, 0})), 2, kExact);
  EXPECT_EQ(map.cost_factor(*map.find({0, 0})), 1);  // cheap ones never lure the robot out of its way
  EXPECT_EQ(map.cost_factor(*map.find({3, 0})), 1);
}

RiskMap travelled() {
  RiskMap map = map_round({0, 0});
  map.grow_around({-1, -1});
  map.cross({-1, -1});
  map.cross({3, 2});
  map.book_cost({3, 2}, 1.5);
  map.fail({4, 2}, 7);
  return map;
}

std::vector<ExperiencePart> stored(const RiskMap& map) { return stored_parts(map, RiskMap::encode); }

TEST(RiskMap, ComesBackFromItsParts) {
  const auto parts = stored(travelled());
  ASSERT_EQ(parts.size(), 5u);
  EXPECT_EQ(parts[0].name, "map");
  EXPECT_EQ(parts[1].name, "tile -1 -1");
  EXPECT_EQ(parts[4].name, "tile 0 0");
  const auto loaded = RiskMap(8, {}).loaded(parts);
  ASSERT_TRUE(loaded) << loaded.error().what.en;
  EXPECT_EQ(loaded->explored(), 3);
  EXPECT_EQ(loaded->occupied(), 1);
  EXPECT_EQ(loaded->find({-1, -1})->label, Label::Empty);
  EXPECT_EQ(loaded->find({3, 2})->cost_j, 1.5);
  EXPECT_EQ(loaded->find({4, 2})->nature, Nature::Static);
  EXPECT_EQ(loaded->find({4, 2})->risk, 0.2);
  EXPECT_EQ(loaded->find({4, 2})->inhibited_until, 0u);  // belongs to the drive, not to experience
  const auto again = stored(*loaded);
  for (std::size_t i = 0; i < parts.size(); ++i) EXPECT_EQ(again[i].bytes, parts[i].bytes);
}

/// The names of the parts that are of another generation than before.
std::vector<std::string> changed(const RiskMap& map, std::vector<PartState>& before) {
  std::vector<std::string> names;
  for (const PartState& part : map.parts()) {
    const auto same = [&part](const PartState& old) {
      return old.name == part.name && old.generation == part.generation;
    };
    if (std::none_of(before.begin(), before.end(), same)) names.emplace_back(part.name);
  }
  before.assign(map.parts().begin(), map.parts().end());
  return names;
}

TEST(RiskMap, TellsWhichOfItsPartsChanged) {
  using Names = std::vector<std::string>;
  RiskMap map = travelled();
  std::vector<PartState> before(map.parts().begin(), map.parts().end());
  EXPECT_EQ(changed(map, before), Names());
  static_cast<void>(map.find({3, 2}));
  map.new_round();
  EXPECT_EQ(changed(map, before), Names());
  map.cross({3, 3});
  EXPECT_EQ(changed(map, before), Names{"tile 0 0"});
  map.fail({-1, -2}, 9);
  EXPECT_EQ(changed(map, before), Names{"tile -1 -1"});
  map.fail_diagonal({0, -1}, 1);
  EXPECT_EQ(changed(map, before), (Names{"tile 0 -1", "tile 0 0"}));
  map.book_cost({-1, -1}, 2);
  EXPECT_EQ(changed(map, before), (Names{"map", "tile -1 -1"}));
  map.grow_around({0, 64});
  EXPECT_EQ(changed(map, before), (Names{"tile -1 1", "tile 0 1"}));
  std::uint64_t newest = 0;
  for (const PartState& part : map.parts()) newest = std::max(newest, part.generation);
  map = *map.loaded(stored(map));
  ASSERT_EQ(map.parts().size(), 7u);
  for (const PartState& part : map.parts()) EXPECT_GT(part.generation, newest) << "none of those it had before";
}

TEST(RiskMap, RefusesEveryCutPart) {
  const auto parts = stored(travelled());
  for (std::size_t part = 0; part < parts.size(); ++part) {
    for (std::size_t size = 0; size < parts[part].bytes.size(); ++size) {
      auto cut = parts;
      cut[part].bytes.resize(size);
      const auto loaded = RiskMap(8, {}).loaded(cut);
      ASSERT_FALSE(loaded);
      EXPECT_EQ(loaded.error().code, ErrorCode::Corrupt);
    }
  }
}

TEST(RiskMap, RefusesValuesThatNoMapCanHave) {
  const auto with_risk = [](double risk) {
    ByteWriter writer;
    for (const std::int32_t value : {0, 0, 1, 17}) writer.i32(value);  // column, row, count, index
    writer.u8(2);
    writer.f64(risk);
    writer.f64(0);
    writer.u32(0);
    return std::vector<ExperiencePart>{{"tile 0 0", writer.take()}};
  };
  EXPECT_TRUE(RiskMap(8, {}).loaded(with_risk(0.5)));
  for (const double risk : {-0.1, 1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(RiskMap(8, {}).loaded(with_risk(risk))) << risk;
  }
  auto twice = with_risk(0.5);
  twice.push_back(twice.front());
  EXPECT_FALSE(RiskMap(8, {}).loaded(twice));
}

TEST(RiskMap, RefusesACellThatComesTwice) {
  ByteWriter writer;
  for (const std::int32_t value : {0, 0, 2}) writer.i32(value);  // column, row, count
  for (int i = 0; i < 2; ++i) {
    writer.i32(17);
    writer.u8(2);
    writer.f64(0.5);
    writer.f64(0);
    writer.u32(0);
  }
  const std::vector<ExperiencePart> parts = {{"tile 0 0", writer.take()}};
  EXPECT_FALSE(RiskMap(8, {}).loaded(parts));
}

TEST(RiskMap, RefusesMoreTilesThanItMayHold) {
  const auto parts = stored(travelled());
  const auto loaded = RiskMap(3, {}).loaded(parts);
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().code, ErrorCode::Unsupported);
}

}  // namespace
}  // namespace ganglion::grid
