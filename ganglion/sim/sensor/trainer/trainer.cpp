#include "ganglion/sim/sensor/trainer/trainer.h"

#include <algorithm>
#include <cmath>

#include "ganglion/math/functions.h"

namespace ganglion::sim {
namespace {

/// The multiple of 45 deg nearest to an angle, as 0..7 counter-clockwise from x.
int eighth_of(Angle heading) noexcept {
  return (static_cast<int>(std::floor(heading.wrapped().rad() / (kPi / 4) + 0.5)) + 8) % 8;
}

}  // namespace

Limits Trainer::limits(std::size_t channel) const noexcept {
  if (channel == 0) return {-1e9, 1e9};
  return {-kPi, kPi};
}

Result<void> Trainer::make_grid(const Scene& scene) {
  if (grid_ && ground_ == scene.world.shared_ground()) return {};
  ground_ = scene.world.shared_ground();
  grid_.reset();  // whatever fails below fails the next reset too
  auto grid = CellGrid::make(*ground_, config_.cell_m, scene.radius_m);
  if (!grid) return tl::unexpected<Error>(grid.error());
  if (config_.max_turn_deg < 180) {
    auto way = SteeredWay::make(*grid, config_.max_turn_deg / 45);
    if (!way) return tl::unexpected<Error>(way.error());
    steered_way_ = std::move(*way);
  }
  grid_ = std::move(*grid);
  workspace_ = grid_->make_workspace();
  if (!ground_->movers().empty()) taken_.reserve(static_cast<std::size_t>(grid_->columns()) * grid_->rows());
  return {};
}

void Trainer::state_goals(CellGrid::Cell start) {
  const auto reachable = grid_->reachable_from(start);
  for (const CellGrid::Cell cell : config_.cells) {
    goals_.push_back({cell, std::find(reachable.begin(), reachable.end(), cell) != reachable.end()});
  }
}

Result<void> Trainer::draw_goals(CellGrid::Cell start, Draws& draws) {
  const auto reachable = grid_->reachable_from(start);
  std::vector<CellGrid::Cell> sealed;
  for (const CellGrid::Cell cell : grid_->free_cells()) {
    // Both lists run row by row.
    const bool within = std::binary_search(reachable.begin(), reachable.end(), cell, [](auto a, auto b) {
      return std::pair(a.row, a.column) < std::pair(b.row, b.column);
    });
    if (!within) sealed.push_back(cell);
  }
  const int sealed_goals = static_cast<int>(std::floor(config_.goals * config_.sealed_share + 0.5));
  if (sealed_goals < config_.goals && reachable.size() < 3) {
    return fail(ErrorCode::BadParameter,
                {"the robot can step to {} cells of {} m from ({}, {}), too few for goals",
                 "el robot puede llegar a {} celdas de {} m desde ({}, {}): muy pocas para objetivos"},
                reachable.size(), config_.cell_m, start.column, start.row);
  }
  if (sealed_goals > 0 && sealed.size() < 2) {
    return fail(ErrorCode::BadParameter,
                {"sealed_share is {}, but the ground has {} free cells out of reach",
                 "sealed_share es {}, pero el terreno tiene {} celdas libres fuera de alcance"},
                config_.sealed_share, sealed.size());
  }
  CellGrid::Cell before = start;
  for (int n = 0, sealed_left = sealed_goals; n < config_.goals; ++n) {
    // Selection sampling: every order of sealed and reachable goals is equally likely.
    const bool is_sealed =
        draws.below(static_cast<std::uint32_t>(config_.goals - n)) < static_cast<std::uint32_t>(sealed_left);
    sealed_left -= is_sealed ? 1 : 0;
    const auto& from = is_sealed ? sealed : reachable;
    CellGrid::Cell cell = before;
    while (cell == before) cell = from[draws.below(static_cast<std::uint32_t>(from.size()))];
    goals_.push_back({cell, !is_sealed});
    before = cell;
  }
  return {};
}

Result<void> Trainer::reset(const Scene& scene, Draws draws) {
  goals_.clear();
  records_.clear();
  next_ = goals_set_ = 0;
  withdrawn_ = false;
  if (auto made = make_grid(scene); !made) return made;
  begin_ = grid_->cell_at(scene.robot.pose.position);
  if (!config_.cells.empty()) {
    state_goals(begin_);
  } else if (auto drawn = draw_goals(begin_, draws); !drawn) {
    return drawn;
  }
  records_.reserve(goals_.size());
  set_next_goal(scene);
  return {};
}

void Trainer::open(const Scene& scene, const Goal& goal) noexcept {
  GoalRecord record{.tick = scene.tick,
                    .start = grid_->cell_at(scene.robot.pose.position),
                    .goal = goal.cell,
                    .reachable = goal.reachable};
  if (grid_->contains(record.start) && grid_->contains(record.goal)) measure_ways(scene, record);
  records_.push_back(record);
  set_s_ = scene.time_s;
  set_travelled_m_ = scene.robot.travelled_m;
}

void Trainer::measure_ways(const Scene& scene, GoalRecord& record) noexcept {
  record.static_shortest_m = grid_->shortest_m(record.start, record.goal, {}, *workspace_);
  record.steered_shortest_m = record.static_shortest_m;
  if (steered_way_) {
    record.steered_shortest_m =
        steered_way_->shortest_m(*grid_, record.start, eighth_of(scene.robot.pose.yaw), record.goal);
  }
  grid_->taken_by_movers(scene.world, taken_);
  record.shortest_m =
      taken_.empty() ? record.static_shortest_m : grid_->shortest_m(record.start, record.goal, taken_, *workspace_);
}

void Trainer::hear(const ActFrame& frame) noexcept {
  for (std::size_t n = 0; n < frame.origins.size() && !withdrawn_; ++n) {
    withdrawn_ = frame.origins[n] == CommandOrigin::Withdrawn;
    reason_ = static_cast<ReasonCode>(frame.reasons[n]);
  }
}

std::optional<GoalOutcome> Trainer::outcome(const Scene& scene) const noexcept {
  if (grid_->cell_at(scene.robot.pose.position) == records_.back().goal) return GoalOutcome::Reached;
  if (withdrawn_) return GoalOutcome::Withdrawn;
  const bool impatient = config_.patience_s > 0 && scene.time_s - set_s_ >= config_.patience_s;
  return impatient ? std::optional(GoalOutcome::TimedOut) : std::nullopt;
}

void Trainer::conclude(const Scene& scene, GoalOutcome outcome) noexcept {
  GoalRecord& record = records_.back();
  record.outcome = outcome;
  record.ticks = scene.tick - record.tick;
  record.travelled_m = scene.robot.travelled_m - set_travelled_m_;
  if (outcome == GoalOutcome::Withdrawn) record.reason = reason_;
}

bool Trainer::done() const noexcept {
  return next_ == goals_.size() && !records_.empty() && records_.back().outcome != GoalOutcome::Open;
}

Result<Vector2> Trainer::set_goal(const Scene& scene, Vector2 point) {
  const CellGrid::Cell cell = grid_->cell_at(point);
  const Vector2 centre = grid_->centre(cell);
  if (!grid_->contains(cell) || !grid_->free(cell)) {
    return fail(ErrorCode::BadParameter,
                {"cell ({}, {}) at ({:.2f}, {:.2f}) cannot be a goal: there is no room for the robot at its centre",
                 "la celda ({}, {}) en ({:.2f}, {:.2f}) no puede ser un objetivo: el robot no cabe en su centro"},
                cell.column, cell.row, centre.x, centre.y);
  }
  if (records_.back().goal == cell) {
    return fail(ErrorCode::BadParameter,
                {"cell ({}, {}) at ({:.2f}, {:.2f}) is the goal already",
                 "la celda ({}, {}) en ({:.2f}, {:.2f}) ya es el objetivo"},
                cell.column, cell.row, centre.x, centre.y);
  }
  if (goals_set_ == kMaxGoalsSet) {
    return fail(ErrorCode::TooLarge,
                {"{} goals have been set in this run; the limit is {}",
                 "ya se fijaron {} objetivos en esta ejecución; el límite es {}"},
                goals_set_, kMaxGoalsSet);
  }
  if (records_.back().outcome == GoalOutcome::Open) conclude(scene, outcome(scene).value_or(GoalOutcome::Replaced));
  withdrawn_ = false;
  ++goals_set_;
  records_.reserve(goals_.size() + goals_set_);
  const auto reachable = grid_->reachable_from(begin_);
  open(scene, {cell, std::find(reachable.begin(), reachable.end(), cell) != reachable.end()});
  return centre;
}

void Trainer::measure(const Scene& scene, Draws&, std::span<double> values) noexcept {
  if (!done()) {
    if (const auto reached = outcome(scene)) {
      conclude(scene, *reached);
      if (next_ < goals_.size()) set_next_goal(scene);
    }
  }
  withdrawn_ = false;
  tell_goal(scene, values);
}

void Trainer::tell_goal(const Scene& scene, std::span<double> values) const noexcept {
  const CellGrid::Cell goal = records_.back().goal;
  const Vector2 way = grid_->centre(goal) - scene.robot.pose.position;
  values[0] = goal.column;
  values[1] = goal.row;
  values[2] = math::atan2(way.y, way.x);
}

}  // namespace ganglion::sim
