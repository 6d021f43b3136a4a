#include "ganglion/sensing/grid_cell/grid_cell.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ganglion/module/testing/request_bench.h"

namespace ganglion {
extern const SensingModuleKind grid_cell_kind;
namespace {

class Locator {
 public:
  explicit Locator(const GridCellConfig& config)
      : ports_(grid_cell_kind.descriptor), module_(std::make_unique<GridCell>(config)), outputs_(ports_.links()) {
    module_->bind(outputs_);
  }
  std::pair<double, double> at(double x_m, double y_m) {
    ports_.set("position", {x_m, y_m});
    module_->cycle(Tick{});
    return {outputs_.outputs[0][0], outputs_.outputs[0][1]};
  }

 private:
  testing::PortBlock ports_;
  std::unique_ptr<GridCell> module_;
  Links outputs_;
};

using Cell = std::pair<double, double>;

TEST(GridCell, RoundsDownOnBothSidesOfTheOrigin) {
  Locator locator({.cell_m = 0.5});
  EXPECT_EQ(locator.at(0, 0), (Cell{0, 0}));
  EXPECT_EQ(locator.at(0.74, 1.01), (Cell{1, 2}));
  EXPECT_EQ(locator.at(-0.01, -0.5), (Cell{-1, -1}));
}

TEST(GridCell, KeepsTheLastCellUntilTheNextCentreIsNear) {
  Locator locator({.cell_m = 1, .reach_m = 0.2});
  EXPECT_EQ(locator.at(0.1, 0.5), (Cell{0, 0}));  // it must begin somewhere
  EXPECT_EQ(locator.at(1.2, 0.5), (Cell{0, 0}));
  EXPECT_EQ(locator.at(1.31, 0.5), (Cell{1, 0}));
  EXPECT_EQ(locator.at(0.9, 0.5), (Cell{1, 0}));
  EXPECT_EQ(locator.at(7.1, 0.5), (Cell{7, 0}));  // carried off
}

TEST(GridCell, KnowsNoCellWithoutAPosition) {
  Locator locator({});
  locator.at(1, 1);
  for (const double lost : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(std::isnan(locator.at(1, lost).first));
    EXPECT_TRUE(std::isnan(locator.at(lost, 1).second));
  }
  EXPECT_EQ(locator.at(1, 1), (Cell{2, 2}));
}

TEST(GridCell, RefusesAReachBeyondTheCell) {
  EXPECT_TRUE(GridCell::judge({1, 0.7}));
  const auto made = GridCell::judge({1, 0.8});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::BadParameter);
}

TEST(GridCell, IsMadeFromItsParameters) {
  EXPECT_TRUE(grid_cell_kind.make(Parameters(grid_cell_kind.descriptor.parameters)));
}

}  // namespace
}  // namespace ganglion
