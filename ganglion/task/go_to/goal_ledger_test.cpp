#include <gtest/gtest.h>

#include "ganglion/task/go_to/go_to.h"

namespace ganglion {
namespace {

/// Where the robot may be told of: a square of 2 m without anything on it.
class Square final : public Terrain {
 public:
  Box2 bounds() const noexcept override { return {{0, 0}, {2, 2}}; }
  double far_wall_m(Vector2, Vector2) const noexcept override { return 0; }
  bool slopes() const noexcept override { return false; }
  double clearance_m(Vector2, double up_to_m) const noexcept override { return up_to_m; }
  bool way_free(Vector2, Vector2, double) const noexcept override { return true; }
};

std::vector<TruthChannel> channels(std::initializer_list<const char*> names) {
  std::vector<TruthChannel> list;
  for (const char* name : names) list.push_back({.name = name, .unit = "", .title = {}});
  return list;
}

TEST(GoTo, SaysWhatItNeedsToBeSet) {
  const Square square;
  const auto known = channels({"x_m", "y_m", "yaw_rad", "travelled_m"});
  GoTo task({.cells = {{1, 1}}});
  EXPECT_EQ(task.settle({known, nullptr, 0.1}).error().code, ErrorCode::Unsupported);
  EXPECT_EQ(task.settle({known, &square, std::nullopt}).error().what.en,
            "goals to go to need a robot on ground that is known here");
  const auto less = channels({"x_m", "y_m", "yaw_rad"});
  EXPECT_EQ(task.settle({less, &square, 0.1}).error().what.en,
            "goals to go to need to know x_m, y_m, yaw_rad and travelled_m of the robot");
  EXPECT_TRUE(task.settle({known, &square, 0.1}));
}

TEST(GoTo, KeepsARowOfEachGoalWithItsPlaceAndAWordForWhatBecameOfIt) {
  const Square square;
  const auto known = channels({"travelled_m", "yaw_rad", "y_m", "x_m"});
  GoTo task({.cells = {{1, 0}, {3, 2}}});
  ASSERT_TRUE(task.settle({known, &square, 0.1}));
  const std::array at_start = {0.0, 0.0, 0.25, 0.25}, at_goal = {0.5, 0.0, 0.25, 0.75};
  ASSERT_TRUE(task.begin({0, 0, at_start, &square}, Draws({}, 0)));
  task.judge({0, 0, at_start, &square});
  const std::uint64_t before = task.ledger()->changes();
  task.judge({1, 1, at_start, &square});
  EXPECT_EQ(task.ledger()->changes(), before) << "nothing happened";
  task.judge({2, 2, at_goal, &square});
  EXPECT_NE(task.ledger()->changes(), before);
  LedgerForm form = task.form();
  const auto value = [&](std::size_t row, std::string_view column) {
    return task.ledger()->at(row, *form.column(column));
  };
  ASSERT_EQ(task.ledger()->rows(), 2u);
  EXPECT_EQ(value(0, "outcome"), 1);
  EXPECT_EQ(value(0, "travelled_m"), 0.5);
  EXPECT_EQ(value(0, "ticks"), 2);
  EXPECT_EQ(value(0, "x_m"), 0.75);
  EXPECT_EQ(value(1, "tick"), 2);
  EXPECT_EQ(value(1, "goal_column"), 3);
  EXPECT_EQ(value(1, "y_m"), 1.25);
  std::vector<double> row;
  for (std::size_t n = 0; n < form.columns.size(); ++n) row.push_back(task.ledger()->at(0, n));
  EXPECT_EQ(row_text(form, 0, row).en, "goal 1 at cell 1, 0: reached");
  EXPECT_EQ(row_text(form, 0, row).es, "objetivo 1 en la celda 1, 0: alcanzado");
}

}  // namespace
}  // namespace ganglion
