#pragma once

#include <optional>

#include "ganglion/module/sensing_module.h"

namespace ganglion {

struct GridCellConfig {
  double cell_m = 0.5;  ///< Side of a cell.
  /// A neighbouring cell counts as reached only within this distance of its centre; until then the last one stands.
  /// 0 = anywhere in it.
  double reach_m = 0;
};

/// The cell of a grid that a position lies in, for modules that think in cells: {column, row} = floor(position /
/// cell_m) (ours).
///
/// Missing   While the position is unknown both values are NaN.
class GridCell final : public SensingModule {
 public:
  /// As judge() leaves it; cell_m > 0.
  explicit GridCell(const GridCellConfig& config) noexcept : config_(config) {}
  /// Fails with BadParameter unless reach_m is 0 or up to half a cell's diagonal.
  static Result<void> judge(const GridCellConfig& config);

 private:
  void perceive(const Feedback& feedback) noexcept override;

  GridCellConfig config_;
  std::optional<Vector2> reached_;  ///< The last cell that counted, as {column, row}.
};

}  // namespace ganglion
