#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/sentence.h"
#include "ganglion/geometry/pose2.h"
#include "ganglion/record/exhibit/track.h"
#include "ganglion/record/run_info.h"

namespace ganglion::plot {

/// A line through points of the ground [m].
struct Outline {
  std::vector<Vector2> points;
  bool closed = false;
};

/// A thing that changes places during the run.
struct Mover {
  std::string id;
  std::vector<Vector2> outline;  ///< Closed, in the mover's own frame [m].
  std::vector<double> times_s;   ///< Ascending: from when each pose holds.
  std::vector<Pose2> poses;
};

/// Corners of an upright rectangle [m].
struct Bounds {
  Vector2 lower{};
  Vector2 upper{};
};

/// A map that the ground was made from, as rectangles of cells.
struct ScannedMap {
  struct Block {
    int column = 0;  ///< Of the lower left cell.
    int row = 0;
    int columns = 0;
    int rows = 0;
  };
  Pose2 origin{};  ///< Lower corner of cell {0, 0}.
  double cell_m = 0;
  int columns = 0;
  int rows = 0;
  std::vector<Block> occupied;
  std::vector<Block> unknown;  ///< Nothing is known of them; as solid as the others.
};

/// The ground the robots drive on.
struct Scene {
  std::vector<Outline> walls;
  std::vector<Outline> furniture;
  std::vector<Outline> solids;  ///< Closed: pillars and other fixed bodies, drawn filled.
  std::optional<ScannedMap> map;
  std::vector<Mover> movers;
  std::vector<Pose2> spawns;
  std::vector<Outline> zones;    ///< Patches of floor unlike the rest; closed.
  std::vector<Outline> bumps;    ///< Ridges that sonar does not see.
  std::vector<Vector2> beacons;  ///< Sources of light or sound.
  std::optional<Bounds> bounds;  ///< None where the run knows no ground.
};

/// A sensor that looks along a ray or into a cone.
struct RangeSensor {
  std::string id;
  std::string kind;     ///< As the robot's file names it: "sonar", "lidar_beam"...
  Pose2 mount{};        ///< On the body.
  double cone_rad = 0;  ///< Full opening angle.
  double max_range_m = 0;
  std::string signal;  ///< Column of RobotView::signals holding the readings.
};

/// Where a robot truly was.
struct Track {
  std::vector<double> times_s;
  std::vector<double> x_m;
  std::vector<double> y_m;
  std::vector<double> yaw_rad;
  std::vector<std::uint8_t> touching;  ///< 1 while the body is in contact with something.
};

struct Column {
  std::string name;
  std::string unit;  ///< "" = dimensionless
};

/// All that was recorded of a robot, one row a tick.
struct SignalTable {
  std::vector<Column> columns;
  std::vector<double> times_s;
  std::vector<double> values;  ///< Row-major; NaN = no reading, +inf = nothing in range, -inf = too close (REP-117).

  std::size_t rows() const noexcept { return times_s.size(); }
  double at(std::size_t row, std::size_t column) const noexcept { return values[row * columns.size() + column]; }
  /// The column of that name; none if there is no such column.
  std::optional<std::size_t> find(const std::string& name) const noexcept;
};

/// What a coordinator decided, one entry a tick.
struct Coordination {
  std::string coordinator;
  std::vector<std::string> candidates;  ///< The behaviours, highest first.
  std::vector<double> times_s;
  std::vector<std::int16_t> active;  ///< Index of the candidate that drives; -1 = none.
  std::vector<std::uint8_t> wanted;  ///< Row-major, one per candidate: 1 = had a command of its own.
  std::vector<float> shares;         ///< Row-major weight of each candidate in the command; empty = winner takes all.

  bool wants(std::size_t row, std::size_t candidate) const noexcept {
    return !wanted.empty() && wanted[row * candidates.size() + candidate] != 0;
  }
};

struct RobotView {
  std::string name;
  double length_m = 0;
  double width_m = 0;
  double radius_m = 0;  ///< > 0 = round body, instead of length and width.
  std::vector<RangeSensor> sensors;
  Track track;
  SignalTable signals;
  std::vector<Coordination> coordinations;

  /// Largest extent of the body [m].
  double extent_m() const noexcept;
};

enum class Severity : std::uint8_t { Info, Warning, Error };

struct Event {
  double time_s = 0;
  Severity severity = Severity::Info;
  Sentence text;  ///< No Spanish where the run was recorded in English only.
};

struct Measure {
  std::string name;  ///< With its SI unit as suffix: "path_m".
  double value = 0;
};

struct RunOutcome {
  Verdict verdict = Verdict::NotJudged;
  Sentence reason;     ///< Why it ended, in plain words; no Spanish where the run was recorded in English only.
  Sentence criterion;  ///< What the experiment calls success; may be empty.
  std::string digest;
};

/// All that pictures and reports need of a run, whatever recorded it. Times are seconds from the start of the run.
struct RunView {
  std::string name;
  std::uint64_t seed = 0;
  double duration_s = 0;
  std::optional<RunOutcome> outcome;  ///< None where the run was cut.
  std::vector<Measure> measures;
  Scene scene;
  std::vector<RobotView> robots;
  std::vector<ExhibitTrack> exhibits;  ///< What was shown, by whomever, in the order of its topics.
  std::vector<Event> events;
};

/// Index of the last entry not later than time_s; none before the first. `times_s` ascends.
std::optional<std::size_t> index_at(std::span<const double> times_s, double time_s) noexcept;

/// Whether it is known of any robot where it was.
bool has_way(const RunView& run) noexcept;

/// The corners of all there is to draw: scene, tracks and what is shown in the world, at least half a metre each way.
Bounds bounds_of(const RunView& run);

}  // namespace ganglion::plot
