#include "ganglion/task/go_to/go_to.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ganglion/math/functions.h"

namespace ganglion {
namespace {

/// The multiple of 45 deg nearest to an angle, as 0..7 counter-clockwise from x.
int eighth_of(Angle heading) noexcept {
  return (static_cast<int>(std::floor(heading.wrapped().rad() / (kPi / 4) + 0.5)) + 8) % 8;
}

}  // namespace

Task::Limits GoTo::limits(std::size_t channel) const noexcept {
  if (channel == 0) return {-1e9, 1e9};
  return {-kPi, kPi};
}

Result<void> GoTo::settle(const TaskSetting& setting) {
  if (setting.terrain == nullptr || !setting.radius_m) {
    return fail(ErrorCode::Unsupported,
                {"goals to go to need a robot on ground that is known here",
                 "los objetivos a los que ir necesitan un robot en un terreno que se conozca aquí"});
  }
  const auto at = [&](std::string_view name) { return index_of(setting.truth, name); };
  const auto x = at("x_m"), y = at("y_m"), yaw = at("yaw_rad"), travelled = at("travelled_m");
  if (!x || !y || !yaw || !travelled) {
    return fail(ErrorCode::Unsupported,
                {"goals to go to need to know x_m, y_m, yaw_rad and travelled_m of the robot",
                 "los objetivos a los que ir necesitan conocer x_m, y_m, yaw_rad y travelled_m del robot"});
  }
  at_ = {*x, *y, *yaw, *travelled};
  auto grid = CellGrid::make(*setting.terrain, config_.cell_m, *setting.radius_m);
  if (!grid) return tl::unexpected<Error>(grid.error());
  if (config_.max_turn_deg < 180) {
    auto way = SteeredWay::make(*grid, config_.max_turn_deg / 45);
    if (!way) return tl::unexpected<Error>(way.error());
    steered_way_ = std::move(*way);
  }
  grid_ = std::move(*grid);
  workspace_ = grid_->make_workspace();
  if (setting.terrain->movers() > 0) taken_.reserve(static_cast<std::size_t>(grid_->columns()) * grid_->rows());
  return {};
}

void GoTo::state_goals(CellGrid::Cell start) {
  const auto reachable = grid_->reachable_from(start);
  for (const CellGrid::Cell cell : config_.cells) {
    goals_.push_back({cell, std::find(reachable.begin(), reachable.end(), cell) != reachable.end()});
  }
}

Result<void> GoTo::draw_goals(CellGrid::Cell start, Draws& draws) {
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

Result<void> GoTo::begin(const Outlook& now, Draws draws) {
  goals_.clear();
  ledger_.clear();
  next_ = goals_set_ = 0;
  withdrawn_ = false;
  begin_ = grid_->cell_at(position(now));
  if (!config_.cells.empty()) {
    state_goals(begin_);
  } else if (auto drawn = draw_goals(begin_, draws); !drawn) {
    return drawn;
  }
  ledger_.reserve(goals_.size());
  set_next_goal(now);
  return {};
}

void GoTo::open(const Outlook& now, const Goal& goal) noexcept {
  GoalRecord record{.tick = now.tick,
                    .start = grid_->cell_at(position(now)),
                    .goal = goal.cell,
                    .reachable = goal.reachable,
                    .centre = grid_->centre(goal.cell)};
  if (grid_->contains(record.start) && grid_->contains(record.goal)) measure_ways(now, record);
  ledger_.open(record);
  set_s_ = now.time_s;
  set_travelled_m_ = now.truth[at_.travelled_m];
}

void GoTo::measure_ways(const Outlook& now, GoalRecord& record) noexcept {
  record.static_shortest_m = grid_->shortest_m(record.start, record.goal, {}, *workspace_);
  record.steered_shortest_m = record.static_shortest_m;
  if (steered_way_) {
    record.steered_shortest_m =
        steered_way_->shortest_m(*grid_, record.start, eighth_of(Angle::from_rad(now.truth[at_.yaw_rad])), record.goal);
  }
  grid_->taken_by_movers(*now.terrain, taken_);
  record.shortest_m =
      taken_.empty() ? record.static_shortest_m : grid_->shortest_m(record.start, record.goal, taken_, *workspace_);
}

void GoTo::hear(const ActFrame& frame) noexcept {
  for (std::size_t n = 0; n < frame.origins.size() && !withdrawn_; ++n) {
    withdrawn_ = frame.origins[n] == CommandOrigin::Withdrawn;
    reason_ = static_cast<ReasonCode>(frame.reasons[n]);
  }
}

std::optional<GoalOutcome> GoTo::outcome(const Outlook& now) const noexcept {
  if (grid_->cell_at(position(now)) == ledger_.last().goal) return GoalOutcome::Reached;
  if (withdrawn_) return GoalOutcome::Withdrawn;
  const bool impatient = config_.patience_s > 0 && now.time_s - set_s_ >= config_.patience_s;
  return impatient ? std::optional(GoalOutcome::TimedOut) : std::nullopt;
}

void GoTo::conclude(const Outlook& now, GoalOutcome outcome) noexcept {
  GoalRecord& record = ledger_.concluding();
  record.outcome = outcome;
  record.ticks = now.tick - record.tick;
  record.travelled_m = now.truth[at_.travelled_m] - set_travelled_m_;
  if (outcome == GoalOutcome::Withdrawn) record.reason = reason_;
}

bool GoTo::done() const noexcept {
  return next_ == goals_.size() && ledger_.rows() > 0 && ledger_.last().outcome != GoalOutcome::Open;
}

std::span<const InterventionDescriptor> GoTo::interventions() const noexcept {
  static constexpr std::array<InterventionArgument, 2> kPoint = {{{"x_m", "m"}, {"y_m", "m"}}};
  static constexpr std::array kList = {InterventionDescriptor{
      .name = "goal",
      .title = {"a goal", "un objetivo"},
      .subject = "",
      .arguments = kPoint,
      .code = 0,
      .line = {"goal of robot {robot} set at ({x_m}, {y_m})", "objetivo del robot {robot} fijado en ({x_m}, {y_m})"}}};
  return kList;
}

Result<Intervened> GoTo::intervene(const Outlook& now, const InterventionDescriptor&,
                                   std::span<const double> arguments) {
  const Vector2 point{arguments[0], arguments[1]};
  const Box2 bounds = now.terrain->bounds();
  if (!bounds.contains(point)) {
    return fail(ErrorCode::BadParameter,
                {"({:.2f}, {:.2f}) lies outside of the world, from ({}, {}) to ({}, {})",
                 "({:.2f}, {:.2f}) está fuera del mundo, que va de ({}, {}) a ({}, {})"},
                point.x, point.y, bounds.lower.x, bounds.lower.y, bounds.upper.x, bounds.upper.y);
  }
  const CellGrid::Cell cell = grid_->cell_at(point);
  const Vector2 centre = grid_->centre(cell);
  if (!grid_->contains(cell) || !grid_->free(cell)) {
    return fail(ErrorCode::BadParameter,
                {"cell ({}, {}) at ({:.2f}, {:.2f}) cannot be a goal: there is no room for the robot at its centre",
                 "la celda ({}, {}) en ({:.2f}, {:.2f}) no puede ser un objetivo: el robot no cabe en su centro"},
                cell.column, cell.row, centre.x, centre.y);
  }
  if (ledger_.last().goal == cell) {
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
  if (ledger_.last().outcome == GoalOutcome::Open) conclude(now, outcome(now).value_or(GoalOutcome::Replaced));
  withdrawn_ = false;
  ++goals_set_;
  ledger_.reserve(goals_.size() + goals_set_);
  const auto reachable = grid_->reachable_from(begin_);
  const bool reached = std::find(reachable.begin(), reachable.end(), cell) != reachable.end();
  open(now, {cell, reached});
  return Intervened{{{"x_m", centre.x}, {"y_m", centre.y}}, reached};
}

void GoTo::judge(const Outlook& now) noexcept {
  if (!done()) {
    if (const auto became = outcome(now)) {
      conclude(now, *became);
      if (next_ < goals_.size()) set_next_goal(now);
    }
  }
  ledger_.set_done(done());
  withdrawn_ = false;
}

void GoTo::tell(const Outlook& now, std::span<double> values) const noexcept {
  const GoalRecord& goal = ledger_.last();
  const Vector2 way = goal.centre - position(now);
  values[0] = goal.goal.column;
  values[1] = goal.goal.row;
  values[2] = math::atan2(way.y, way.x);
}

}  // namespace ganglion
