#pragma once

#include <functional>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ganglion/acting/dynamic_map_router/dynamic_map_router.h"
#include "ganglion/module/testing/request_bench.h"
#include "ganglion/units/angle.h"

namespace ganglion {

extern const ActingModuleKind dynamic_map_router_kind;

namespace testing {

/// A robot on a grid of walls, for the tests of DynamicMapRouter: a step turns it by at most 45 deg and takes it one
/// cell forwards or backwards; it cannot cut corners. Written without the code under test.
class GridBot {
 public:
  /// Drawn with the first line on top: '#' wall, anything else free. Outside is wall.
  explicit GridBot(const std::vector<std::string>& lines) : rows_(static_cast<int>(lines.size())) {
    columns_ = static_cast<int>(lines.front().size());
    for (int r = 0; r < rows_; ++r) {
      const std::string& line = lines[static_cast<std::size_t>(rows_ - 1 - r)];
      for (int c = 0; c < columns_; ++c) {
        if (line[static_cast<std::size_t>(c)] == '#') walls.insert({c, r});
      }
    }
  }

  bool blocked(int c, int r) const {
    return c < 0 || r < 0 || c >= columns_ || r >= rows_ || walls.contains({c, r}) || blocks.contains({c, r});
  }
  /// Whether a step in direction `k` from a cell is possible.
  bool passable(int c, int r, int k) const {
    const int dc = kColumns[k];
    const int dr = kRows[k];
    if (blocked(c + dc, r + dr)) return false;
    return dc == 0 || dr == 0 || (!blocked(c + dc, r) && !blocked(c, r + dr));
  }

  /// Carries out one command; the cost is 2 J a cell of length, 1 J for an attempt that fails.
  void act(const Command& command) {
    contact = false;
    cost_j = 0;
    if (command.kind != CommandKind::Act) return;
    const int k = static_cast<int>(std::lround(command.values[1] / (kPi / 4)) + 8) % 8;
    const bool forward = command.values[0] > 0;
    const int wanted = forward ? k : (k + 4) % 8;
    const int turn = (wanted - heading + 8) % 8;
    if (turn != 0 && turn != 1 && turn != 7) {
      ++illegal;
      return;
    }
    ++steps;
    backward_steps += forward ? 0 : 1;
    if (!passable(column, row, k)) {
      ++bumps;
      contact = true;
      cost_j = 1;
      return;
    }
    heading = wanted;
    column += kColumns[k];
    row += kRows[k];
    const double step = k % 2 == 0 ? 1 : std::numbers::sqrt2;
    length += step;
    weighted += forward ? step : 2 * step;
    cost_j = 2 * step * dearness(column, row);
  }

  static constexpr int kColumns[8] = {1, 1, 0, -1, -1, -1, 0, 1};
  static constexpr int kRows[8] = {0, 1, 1, 1, 0, -1, -1, -1};

  int column = 0, row = 0, heading = 0;
  bool contact = false;
  double cost_j = 0;
  double length = 0;    ///< Driven so far, in cells.
  double weighted = 0;  ///< The same, backwards counted twice.
  int steps = 0, bumps = 0, backward_steps = 0, illegal = 0;
  std::set<std::pair<int, int>> walls;
  std::set<std::pair<int, int>> blocks;  ///< Obstacles that a test moves about.
  std::function<double(int, int)> dearness = [](int, int) { return 1.0; };
  int columns() const { return columns_; }
  int rows() const { return rows_; }

 private:
  int columns_ = 0;
  int rows_ = 0;
};

/// Free ground with the robot on a cell of it, heading east.
inline GridBot open_ground(int column = 5, int row = 5, int side = 12) {
  const auto n = static_cast<std::size_t>(side);
  GridBot bot(std::vector<std::string>(n, std::string(n, '.')));
  bot.column = column;
  bot.row = row;
  return bot;
}

/// The module driving the bot.
class Drive {
 public:
  explicit Drive(GridBot& bot, const DynamicMapRouterConfig& config = small())
      : bot_(&bot),
        module_(std::make_unique<DynamicMapRouter>(config)),
        bench_(*module_, dynamic_map_router_kind.descriptor) {}

  /// A window that fits the maps of these tests, so that they run fast.
  static DynamicMapRouterConfig small() {
    DynamicMapRouterConfig config;
    config.router.window_cells = 64;
    return config;
  }

  /// One tick: the bot's senses in, the command out, the bot moves.
  const Command& tick() {
    PortBlock& ports = bench_.ports();
    ports.set("cell", {static_cast<double>(bot_->column), static_cast<double>(bot_->row)});
    ports.set("heading", {wrap_rad(bot_->heading * kPi / 4)});
    ports.set("position", {(bot_->column + 0.5) * 0.5, (bot_->row + 0.5) * 0.5});
    ports.set("contact", {bot_->contact ? 1.0 : 0.0});
    ports.set("goal_direction", {std::numeric_limits<double>::quiet_NaN()});
    const Command& command = bench_.tick(first_ ? std::nullopt : std::optional<double>(bot_->cost_j));
    first_ = false;
    bot_->act(command);
    return command;
  }
  /// Asks for a cell and drives until the request is settled, or for `most` ticks.
  RequestStatus go(int column, int row, int most = 5000) {
    bench_.ask({static_cast<double>(column), static_cast<double>(row)});
    ticks = 0;
    while (ticks < most && bench_.request().status == RequestStatus::Pending) {
      if (before_tick) before_tick();
      tick();
      ++ticks;
    }
    return bench_.request().status;
  }

  RequestBench& bench() { return bench_; }
  DynamicMapRouter& module() { return *module_; }
  double output(std::string_view name) const { return const_cast<Drive*>(this)->bench_.ports().output(name); }
  const grid::Cell& cell(int column, int row) const { return *module_->map().find({column, row}); }
  ReasonCode reason() { return bench_.request().reason.code; }

  int ticks = 0;  ///< Of the last go().
  std::function<void()> before_tick;

 private:
  GridBot* bot_;
  std::unique_ptr<DynamicMapRouter> module_;
  RequestBench bench_;
  bool first_ = true;
};

}  // namespace testing
}  // namespace ganglion
