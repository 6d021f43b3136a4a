#include "ganglion/report/player_data.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ganglion/record/exhibit/exhibit_json.h"
#include "ganglion/report/dictionary.h"
#include "ganglion/report/packed.h"
#include "ganglion/report/player_exhibits.h"

namespace ganglion::report {
namespace {

using plot::RobotView;
using Json = nlohmann::json;

constexpr std::size_t kMaxCoordinations = 6;
constexpr std::size_t kMaxSceneItems = 20000;
constexpr std::size_t kMaxPlayerEvents = 1000;
constexpr std::uint16_t kNoReading = 65535;  // the same as in the player's data.js
constexpr std::uint16_t kNothingInRange = 65534;
constexpr std::uint16_t kTooClose = 65533;
constexpr double kTopReading = 65000;

/// To a millimetre; null for what is not finite.
Json rounded(double value) { return std::isfinite(value) ? Json(std::round(value * 1000) / 1000) : Json(nullptr); }

bool finite(Vector2 p) noexcept { return std::isfinite(p.x) && std::isfinite(p.y); }

/// [x, y, x, y...] of the points that are finite.
Json flat(const std::vector<Vector2>& points) {
  Json list = Json::array();
  for (const Vector2 p : points)
    if (finite(p)) list.insert(list.end(), {rounded(p.x), rounded(p.y)});
  return list;
}

Json outlines(const std::vector<plot::Outline>& pieces) {
  Json list = Json::array();
  for (const plot::Outline& piece : pieces) {
    if (list.size() >= kMaxSceneItems) break;
    list.push_back({{"points", flat(piece.points)}, {"closed", piece.closed}});
  }
  return list;
}

std::string pack_blocks(const std::vector<plot::ScannedMap::Block>& blocks) {
  std::vector<std::uint16_t> numbers;
  for (const auto& block : blocks)
    for (const int number : {block.column, block.row, block.columns, block.rows})
      numbers.push_back(static_cast<std::uint16_t>(std::clamp(number, 0, 65535)));
  return pack_u16(numbers);
}

Json map_of(const plot::ScannedMap& map) {
  return {{"x", rounded(map.origin.position.x)},   {"y", rounded(map.origin.position.y)},
          {"yaw", map.origin.yaw.rad()},           {"cell", map.cell_m},
          {"occupied", pack_blocks(map.occupied)}, {"unknown", pack_blocks(map.unknown)}};
}

Json scene_of(const plot::Scene& scene) {
  Json movers = Json::array();
  for (const plot::Mover& mover : scene.movers) {
    Json poses = Json::array();
    for (const Pose2& pose : mover.poses)
      poses.insert(poses.end(), {rounded(pose.position.x), rounded(pose.position.y), rounded(pose.yaw.rad())});
    movers.push_back({{"outline", flat(mover.outline)}, {"times", mover.times_s}, {"poses", std::move(poses)}});
  }
  return {{"zones", outlines(scene.zones)},
          {"bumps", outlines(scene.bumps)},
          {"beacons", flat(scene.beacons)},
          {"walls", outlines(scene.walls)},
          {"furniture", outlines(scene.furniture)},
          {"solids", outlines(scene.solids)},
          {"map", scene.map ? map_of(*scene.map) : Json(nullptr)},
          {"movers", std::move(movers)}};
}

/// Every `stride`-th value, the last one always.
class Rows {
 public:
  Rows(std::size_t count, std::size_t stride) {
    for (std::size_t i = 0; i < count; i += stride) rows_.push_back(i);
    if (count > 0 && rows_.back() + 1 != count) rows_.push_back(count - 1);
  }
  template <class Value>
  std::vector<Value> pick(const std::vector<Value>& values) const {
    std::vector<Value> picked;
    for (const std::size_t row : rows_)
      if (row < values.size()) picked.push_back(values[row]);
    return picked;
  }

 private:
  std::vector<std::size_t> rows_;
};

std::uint16_t packed_reading(double range_m, double unit_m) noexcept {
  if (std::isnan(range_m)) return kNoReading;
  if (std::isinf(range_m)) return range_m > 0 ? kNothingInRange : kTooClose;
  return static_cast<std::uint16_t>(std::clamp(std::round(range_m / unit_m), 0.0, kTopReading));
}

Json sensor_of(const RobotView& robot, const plot::RangeSensor& sensor, const std::vector<double>& times_s) {
  const auto column = robot.signals.find(sensor.signal);
  const double unit_m = std::isfinite(sensor.max_range_m) ? std::max(sensor.max_range_m / kTopReading, 1e-4) : 1e-3;
  std::vector<std::uint16_t> readings;
  for (const double time_s : times_s) {
    const auto row = column ? plot::index_at(robot.signals.times_s, time_s) : std::nullopt;
    readings.push_back(row ? packed_reading(robot.signals.at(*row, *column), unit_m) : kNoReading);
  }
  return {{"id", sensor.id},
          {"x", rounded(sensor.mount.position.x)},
          {"y", rounded(sensor.mount.position.y)},
          {"yaw", sensor.mount.yaw.rad()},
          {"cone", sensor.cone_rad},
          {"max", rounded(sensor.max_range_m)},
          {"unit_m", unit_m},
          {"readings", pack_u16(readings)}};
}

Json coordination_of(const plot::Coordination& coordination, const std::vector<double>& times_s) {
  const std::size_t width = coordination.candidates.size();
  std::vector<std::uint8_t> active, wanted, shares;
  for (const double time_s : times_s) {
    const auto row = plot::index_at(coordination.times_s, time_s);
    active.push_back(static_cast<std::uint8_t>(row ? std::clamp<int>(coordination.active[*row], -1, 127) : -1));
    for (std::size_t i = 0; i < width; ++i) {
      wanted.push_back(row && coordination.wants(*row, i));
      if (coordination.shares.empty()) continue;
      const float share = row ? coordination.shares[*row * width + i] : 0;
      shares.push_back(share > 0 ? static_cast<std::uint8_t>(std::min(share, 1.0f) * 255) : 0);
    }
  }
  return {{"name", coordination.coordinator},
          {"candidates", coordination.candidates},
          {"active", pack_u8(active)},
          {"wanted", pack_u8(wanted)},
          {"shares", pack_u8(shares)}};
}

/// Columns that exhibits depend on, at the rows that are kept.
Json columns_of(const plot::RunView& run, std::size_t robot, const Rows& rows) {
  const plot::SignalTable& signals = run.robots[robot].signals;
  Json columns = Json::object();
  for (const std::string& name : columns_needed(run, static_cast<int>(robot))) {
    const std::size_t column = *signals.find(name);
    std::vector<double> values;
    for (std::size_t row = 0; row < signals.rows(); ++row) values.push_back(signals.at(row, column));
    columns[name] = pack_f32(rows.pick(values));
  }
  return columns;
}

Json robot_of(const plot::RunView& run, std::size_t number, std::size_t stride) {
  const RobotView& robot = run.robots[number];
  const Rows rows(robot.track.times_s.size(), stride);
  const std::vector<double> times_s = rows.pick(robot.track.times_s);
  Json sensors = Json::array();
  for (const plot::RangeSensor& sensor : robot.sensors) sensors.push_back(sensor_of(robot, sensor, times_s));
  Json coordinations = Json::array();
  for (std::size_t i = 0; i < std::min(robot.coordinations.size(), kMaxCoordinations); ++i)
    coordinations.push_back(coordination_of(robot.coordinations[i], times_s));
  return {{"name", robot.name},
          {"length", rounded(robot.length_m)},
          {"width", rounded(robot.width_m)},
          {"radius", rounded(robot.radius_m)},
          {"t", pack_f32(times_s)},
          {"x", pack_f32(rows.pick(robot.track.x_m))},
          {"y", pack_f32(rows.pick(robot.track.y_m))},
          {"yaw", pack_f32(rows.pick(robot.track.yaw_rad))},
          {"touching", pack_u8(rows.pick(robot.track.touching))},
          {"sensors", std::move(sensors)},
          {"coordinations", std::move(coordinations)},
          {"columns", columns_of(run, number, rows)}};
}

std::size_t bytes_of(const RobotView& robot) noexcept {
  std::size_t per_row = 17 + 2 * robot.sensors.size();
  for (std::size_t i = 0; i < std::min(robot.coordinations.size(), kMaxCoordinations); ++i)
    per_row += 1 + robot.coordinations[i].candidates.size() * (robot.coordinations[i].shares.empty() ? 1 : 2);
  return per_row * robot.track.times_s.size() * 4 / 3;
}

Json events_of(const plot::RunView& run) {
  static constexpr const char* kLevels[] = {"info", "warning", "error"};
  Json list = Json::array();
  for (std::size_t i = 0; i < std::min(run.events.size(), kMaxPlayerEvents); ++i)
    list.push_back(
        {{"t", rounded(run.events[i].time_s)}, {"level", kLevels[static_cast<int>(run.events[i].severity)]}});
  return list;
}

}  // namespace

std::string player_data(const plot::RunView& run, std::size_t max_bytes) {
  std::size_t bytes = 0;
  for (const RobotView& robot : run.robots) bytes += bytes_of(robot);
  const std::size_t stride = std::max<std::size_t>(1, (bytes + max_bytes - 1) / std::max<std::size_t>(1, max_bytes));
  Json robots = Json::array();
  for (std::size_t i = 0; i < run.robots.size(); ++i) robots.push_back(robot_of(run, i, stride));
  const plot::Bounds bounds = plot::bounds_of(run);
  const Json data{{"duration", rounded(run.duration_s)},
                  {"bounds", flat({bounds.lower, bounds.upper})},
                  {"scene", scene_of(run.scene)},
                  {"robots", std::move(robots)},
                  {"roles", roles_json()},
                  {"exhibits", exhibits_json(run)},
                  {"events", events_of(run)}};
  return fit_for_script(data.dump(-1, ' ', true, Json::error_handler_t::replace));
}

}  // namespace ganglion::report
