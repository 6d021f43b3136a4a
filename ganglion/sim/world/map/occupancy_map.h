#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include "ganglion/base/files.h"
#include "ganglion/base/result.h"
#include "ganglion/geometry/pose2.h"
#include "ganglion/sim/world/shape/shape.h"

namespace ganglion::sim {

enum class Occupancy : std::uint8_t { Free, Occupied, Unknown };

/// Largest text of a map [bytes].
inline constexpr std::size_t kMaxMapText = std::size_t{1} << 20;

/// Largest image taken as a map [cells].
inline constexpr std::size_t kMaxMapCells = std::size_t{64} << 20;

/// A ROS map_server map, mode trinary: row 0 is the lowest, column 0 the leftmost in the map's frame.
/// A cell with shade p = (maxval - value) / maxval (value / maxval if negated) is Occupied if p > occupied_thresh, Free
/// if p < free_thresh, else Unknown. Robots and rays treat Unknown, and what lies beyond the image, as solid. Source:
/// wiki.ros.org/map_server, sections 1.2 and 1.3.
class OccupancyMap {
 public:
  /// Cells in rows from the lowest up. `origin` is the pose of the lower left corner of the lower left cell.
  OccupancyMap(int columns, int rows, double resolution_m, const Pose2& origin, std::vector<Occupancy> cells);
  /// Reads the YAML file and the PGM image it names. Every problem goes into `problems`, at its line; the first is the
  /// error: Syntax, MissingKey, BadType, BadParameter, Unsupported (modes other than trinary, other image formats),
  /// TooLarge, NotFound, Corrupt. Keys that we do not know are other programs' and left alone.
  static Result<OccupancyMap> load(FileReader& files, int yaml, Problems& problems);
  /// The same of a file of the disk.
  static Result<OccupancyMap> load(const std::filesystem::path& yaml_path, Problems& problems);

  int columns() const noexcept { return columns_; }
  int rows() const noexcept { return rows_; }
  double resolution_m() const noexcept { return resolution_m_; }
  const Pose2& origin() const noexcept { return origin_; }
  /// Unknown outside the image.
  Occupancy at(int column, int row) const noexcept {
    const bool within = column >= 0 && row >= 0 && column < columns_ && row < rows_;
    return within ? cells_[static_cast<std::size_t>(row) * columns_ + column] : Occupancy::Unknown;
  }
  /// The cell under a point of the world; Unknown outside the image.
  Occupancy at(Vector2 point) const noexcept;
  /// Cells that are Free, Occupied, Unknown.
  std::array<std::size_t, 3> counts() const noexcept;
  /// A corner between cells, 0..columns and 0..rows, in the world.
  Vector2 corner(int column, int row) const noexcept;
  Box2 bounds() const noexcept;

  /// The borders between free cells and all others, in the world, the solid on their left, runs merged. Stops when it
  /// has found more than `limit`.
  std::vector<std::pair<Vector2, Vector2>> borders(std::size_t limit) const;

 private:
  bool free(int column, int row) const noexcept { return at(column, row) == Occupancy::Free; }

  int columns_;
  int rows_;
  double resolution_m_;
  Pose2 origin_;
  Vector2 along_;  ///< Unit vector of the map's x axis.
  std::vector<Occupancy> cells_;
};

}  // namespace ganglion::sim
