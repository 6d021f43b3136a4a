#include "ganglion/grid/unexplored_risk.h"

#include <gtest/gtest.h>

#include "ganglion/grid/price.h"

namespace ganglion::grid {
namespace {

RiskMap map_with_occupied(std::initializer_list<CellIndex> occupied) {
  RiskMap map(4, {});
  map.grow_around({4, 4});
  for (const CellIndex cell : occupied) map.fail(cell, 0);
  return map;
}

TEST(UnexploredRisk, IsThatOfOpenGroundFarFromEverything) {
  const RiskMap map = map_with_occupied({{9, 4}});
  EXPECT_EQ(unexplored_risk(map, {4, 4}, {}), 0.1);  // one cell in line is no wall
  EXPECT_EQ(unexplored_risk(map, {500, 500}, {}), 0.1);
}

TEST(UnexploredRisk, RisesBesideAnOccupiedCellAndMoreBetweenTwo) {
  const RiskMap map = map_with_occupied({{3, 4}, {5, 4}, {9, 9}});
  EXPECT_EQ(unexplored_risk(map, {2, 4}, {}), 0.3);
  EXPECT_EQ(unexplored_risk(map, {4, 4}, {}), 0.8);
  EXPECT_EQ(unexplored_risk(map, {9, 8}, {}), 0.3);
  EXPECT_EQ(unexplored_risk(map, {8, 8}, {}), 0.1);  // across a corner nothing follows
}

TEST(UnexploredRisk, ExpectsAWallToGoOnUntilSomethingEmptyEndsIt) {
  RiskMap map = map_with_occupied({{10, 4}, {12, 4}, {14, 4}});
  EXPECT_EQ(unexplored_risk(map, {4, 4}, {}), 0.3);
  EXPECT_EQ(unexplored_risk(map, {1, 4}, {}), 0.1);  // the third lies 13 cells away
  map.cross({7, 4});
  EXPECT_EQ(unexplored_risk(map, {4, 4}, {}), 0.1);
}

TEST(UnexploredRisk, CanBeSwitchedOff) {
  const RiskMap map = map_with_occupied({{3, 4}, {5, 4}});
  EXPECT_EQ(unexplored_risk(map, {4, 4}, {.inferred = false}), 0);
  const PriceRule free{.unexplored = {.inferred = false}};
  EXPECT_EQ(Pricing(map, free, Query::Secure, 100)({4, 4}).risk, 0u);
  EXPECT_GT(Pricing(map, {}, Query::Secure, 100)({4, 4}).risk, 0u);
}

TEST(UnexploredRisk, IsSharedByTheSuspectsOfAFailedDiagonalStep) {
  RiskMap map = map_with_occupied({});
  map.fail_diagonal({4, 4}, 1);
  for (const CellIndex suspect : {CellIndex{5, 4}, {5, 5}, {4, 5}}) {
    EXPECT_EQ(map.find(suspect)->label, Label::Unexplored);
    EXPECT_NEAR(unexplored_risk(map, suspect, {}), 0.3, 1e-12);  // 0.9 / 3
  }
  map.cross({5, 4});
  map.fail_diagonal({4, 4}, 1);
  EXPECT_EQ(map.find({5, 4})->risk, 0);
  EXPECT_NEAR(unexplored_risk(map, {5, 5}, {}), 0.45, 1e-12);  // 0.9 / 2
}

}  // namespace
}  // namespace ganglion::grid
