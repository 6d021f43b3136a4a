#include "ganglion/record/exhibit/shown.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ganglion::shown {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

TEST(ShownLayer, SpreadsItsScaleOverAByteAndKeepsOneForTheUnknown) {
  const Layer layer{.name = "heat", .low = -10, .high = 30};
  EXPECT_EQ(layer.byte_of(-10), 0);
  EXPECT_EQ(layer.byte_of(30), 254);
  EXPECT_EQ(layer.byte_of(10), 127);
  EXPECT_EQ(layer.byte_of(1e9), 254);
  EXPECT_EQ(layer.byte_of(kNone), kUnknownCell);
  EXPECT_DOUBLE_EQ(layer.value_of(127), 10);
  EXPECT_TRUE(std::isnan(layer.value_of(kUnknownCell)));
}

TEST(ShownLayer, NamesTheNearestClass) {
  const Layer layer{.name = "label",
                    .classes = {{0.5, Role::Free, {"free", "libre"}}, {1, Role::Solid, {"full", "llena"}}}};
  EXPECT_EQ(layer.class_of(layer.byte_of(0.5))->role, Role::Free);
  EXPECT_EQ(layer.class_of(layer.byte_of(1))->role, Role::Solid);
  EXPECT_EQ(layer.class_of(kUnknownCell), nullptr);
  EXPECT_EQ(Layer{}.class_of(3), nullptr);
}

Field field_of(int columns, int rows, std::uint8_t fill) {
  Field field;
  field.columns = columns;
  field.rows = rows;
  field.layers.resize(2);
  field.cells.assign(2, std::vector<std::uint8_t>(static_cast<std::size_t>(columns * rows), fill));
  return field;
}

TEST(ShownField, DiffersInTheLeastRectangle) {
  const Field before = field_of(4, 3, 9);
  Field now = before;
  EXPECT_FALSE(difference(before, now));
  now.cells[0][1 * 4 + 2] = 1;
  now.cells[1][2 * 4 + 1] = 2;
  const auto patch = difference(before, now);
  ASSERT_TRUE(patch);
  EXPECT_EQ(patch->column, 1);
  EXPECT_EQ(patch->row, 1);
  EXPECT_EQ(patch->columns, 2);
  EXPECT_EQ(patch->rows, 2);
  EXPECT_EQ(patch->cells[0], (std::vector<std::uint8_t>{9, 1, 9, 9}));
  EXPECT_EQ(patch->cells[1], (std::vector<std::uint8_t>{9, 9, 2, 9}));
  Field again = before;
  EXPECT_TRUE(apply(*patch, again));
  EXPECT_EQ(again.cells, now.cells);
}

TEST(ShownField, TakesNoPatchThatDoesNotFit) {
  Field field = field_of(4, 3, 9);
  const Patch good{3, 2, 1, 1, {{1}, {1}}};
  EXPECT_TRUE(fits(good, field));
  for (const Patch& bad :
       {Patch{4, 2, 1, 1, {{1}, {1}}}, Patch{-1, 0, 1, 1, {{1}, {1}}}, Patch{3, 2, 2, 1, {{1, 1}, {1, 1}}},
        Patch{3, 2, 1, 1, {{1}}}, Patch{3, 2, 1, 1, {{1}, {1, 2}}}, Patch{0, 0, 0, 0, {{}, {}}},
        Patch{1, 1, std::numeric_limits<int>::max(), 1, {{1}, {1}}}}) {
    EXPECT_FALSE(apply(bad, field));
  }
  EXPECT_EQ(field.cells, field_of(4, 3, 9).cells);
}

}  // namespace
}  // namespace ganglion::shown
