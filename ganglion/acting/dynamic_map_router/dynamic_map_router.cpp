#include "ganglion/acting/dynamic_map_router/dynamic_map_router.h"

#include <cmath>
#include <limits>

#include "ganglion/math/functions.h"
#include "ganglion/units/angle.h"

namespace ganglion {
namespace {

using grid::CellIndex;
using grid::Motion;
using grid::RouteStep;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Command command_of(const RouteStep& step) noexcept {
  const double direction_rad = wrap_rad(step.direction * (kPi / 4));
  return Command::act({static_cast<double>(step.motion), direction_rad});
}

bool whole_cell(std::span<const double> request) noexcept {
  if (request.size() != 2) return false;
  const auto whole = [](double v) { return std::fabs(v) < grid::kFarthestCell && std::floor(v) == v; };
  return whole(request[0]) && whole(request[1]);
}

}  // namespace

Result<void> DynamicMapRouter::judge(DynamicMapRouterConfig& config) {
  config.router.max_turn = config.max_turn_deg / 45;
  config.price.secure_weighs_cost = config.secure_by == SecureBy::Cost;
  return {};
}

DynamicMapRouter::DynamicMapRouter(const DynamicMapRouterConfig& config)
    : config_(config),
      map_(config.max_tiles, config.risk),
      router_(config.router),
      trail_(static_cast<std::size_t>(config.go_back_steps)) {
  map_.set_dynamic_tries(config.dynamic_tries);
  commands_.reserve(grid::kLongestRoute);
}

void DynamicMapRouter::grow() {
  if (cell_) map_.grow_around(*cell_);
}

Result<void> DynamicMapRouter::load(std::uint32_t version, std::span<const ExperiencePart> parts) {
  if (version != 1 && version != 2) {
    return fail(ErrorCode::Unsupported,
                {"saved map of version {}, this program reads 1 and 2",
                 "el mapa guardado es de la versión {}; este programa lee la 1 y la 2"},
                version);
  }
  auto map = map_.loaded(parts);
  if (!map) return tl::unexpected<Error>(map.error());
  map_ = std::move(*map);
  trail_.clear();
  attempt_.reset();
  drop_route();
  return {};
}

Command DynamicMapRouter::internal_propagation(const Request& request, const Feedback& feedback) noexcept {
  attend(feedback, kNone);
  if (request.fresh) accept(request.values);
  const Command command = decide(request, feedback);
  publish(phase_, feedback);
  return command;
}

void DynamicMapRouter::accept(std::span<const double> request) noexcept {
  goal_.reset();
  if (whole_cell(request)) goal_ = {static_cast<std::int32_t>(request[0]), static_cast<std::int32_t>(request[1])};
  rounds_ = 0;
  failures_ = 0;
  silent_since_s_.reset();
  map_.new_round();
  drop_route();
}

Command DynamicMapRouter::decide(const Request& request, const Feedback& feedback) noexcept {
  if (!goal_) {
    const auto value = [&](std::size_t i) { return i < request.values.size() ? request.values[i] : kNone; };
    return give_up({ReasonCode::BadRequest, value(0), value(1)});
  }
  const ReasonCode below = feedback.outcome == RequestStatus::Withdrawn ? feedback.reason.code : ReasonCode::None;
  if (below == ReasonCode::NoReading || below == ReasonCode::BadRequest) return give_up(feedback.reason);
  if (!cell_read_ || !heading_) return hold(feedback);
  silent_since_s_.reset();
  if (*cell_ == *goal_) return Command::inactive();
  if (outside_map()) {
    return give_up({ReasonCode::OutsideMap, static_cast<double>(goal_->column), static_cast<double>(goal_->row)});
  }
  if (keeps_route() || finds_route()) return follow_route();
  return retreat();
}

/// No step without knowing where one stands.
Command DynamicMapRouter::hold(const Feedback& feedback) noexcept {
  if (!silent_since_s_) silent_since_s_ = feedback.tick.time_s;
  const double silent_s = feedback.tick.time_s - *silent_since_s_;
  if (silent_s < config_.patience_s) return Command::inactive();
  return give_up({ReasonCode::NoReading, static_cast<double>(cell_read_ ? kHeading : kCell), silent_s});
}

Command DynamicMapRouter::follow_route() noexcept { return go(router_.route()[next_]); }

Command DynamicMapRouter::go(const RouteStep& step) noexcept {
  attempt_ = step;
  attempt_cost_j_ = 0;
  attempt_costed_ = false;
  return command_of(step);
}

/// No route: back along the way that led here; at its end wait until inhibitions lapse and try all of it again.
Command DynamicMapRouter::retreat() noexcept {
  const auto back = trail_.way_back(*cell_);
  if (back && can_turn_to(back->heading) && pricing(Phase::Feasible).may_step(back->from, back->direction)) {
    phase_ = Phase::GoBack;
    return go(*back);
  }
  trail_.clear();
  phase_ = Phase::Wait;
  if (map_.next_lapse(now_)) return Command::inactive();
  if (++rounds_ >= config_.rounds) {
    if (!trapped()) {
      return give_up({ReasonCode::Unreachable, static_cast<double>(failures_), static_cast<double>(rounds_)});
    }
    return give_up({ReasonCode::Trapped, static_cast<double>(cell_->column), static_cast<double>(cell_->row)});
  }
  map_.new_round();
  no_route_ = false;
  return finds_route() ? follow_route() : Command::inactive();
}

Command DynamicMapRouter::give_up(Reason reason) noexcept {
  drop_route();
  attempt_.reset();
  return Command::withdraw(reason);
}

grid::Pricing DynamicMapRouter::pricing(Phase phase) const noexcept {
  const grid::Query query = phase == Phase::Secure ? grid::Query::Secure : grid::Query::Feasible;
  return {map_, config_.price, query, now_};
}

bool DynamicMapRouter::keeps_route() const noexcept {
  if (phase_ != Phase::Secure && phase_ != Phase::Feasible) return false;
  const auto route = router_.route();
  if (next_ >= route.size() || route[next_].from != *cell_ || !can_turn_to(route[next_].heading)) return false;
  const grid::Pricing allowed = pricing(phase_);
  for (const RouteStep& step : route.subspan(next_)) {
    if (!allowed.may_step(step.from, step.direction)) return false;
  }
  return true;
}

bool DynamicMapRouter::finds_route() noexcept {
  const bool lapsed = no_route_until_ && now_ >= *no_route_until_;
  if (no_route_ && no_route_revision_ == map_.revision() && !lapsed) return false;
  for (const Phase phase : {Phase::Secure, Phase::Feasible}) {
    if (router_.find(pricing(phase), *cell_, *heading_, *goal_) != grid::Router::Outcome::Found) continue;
    phase_ = phase;
    take_route();
    return true;
  }
  commands_.clear();
  no_route_ = true;
  no_route_revision_ = map_.revision();
  no_route_until_ = map_.next_lapse(now_);
  return false;
}

bool DynamicMapRouter::outside_map() const noexcept {
  const int reach = config_.router.window_cells / 2 - 2;
  const bool closed = map_.full() && (map_.find(*goal_) == nullptr || map_.find(*cell_) == nullptr);
  return closed || steps_between(*cell_, *goal_) > 2 * reach;
}

bool DynamicMapRouter::can_turn_to(int heading) const noexcept {
  return std::abs(grid::turn_between(*heading_, heading)) <= config_.router.max_turn;
}

/// Whether every step that the steering allows from here leads to a cell known to be occupied, or past one.
bool DynamicMapRouter::trapped() const noexcept {
  const auto blocked = [this](int direction) {
    const grid::Cell* cell = map_.find(neighbour(*cell_, direction));
    return cell != nullptr ? cell->label == grid::Label::Occupied : map_.full();
  };
  for (int k = 0; k < grid::kDirections; ++k) {
    if (!can_turn_to(k) && !can_turn_to(grid::turned(k, 4))) continue;
    const bool corner = grid::is_diagonal(k) && (blocked(grid::turned(k, -1)) || blocked(grid::turned(k, 1)));
    if (!blocked(k) && !corner) return false;
  }
  return true;
}

void DynamicMapRouter::take_route() noexcept {
  next_ = 0;
  no_route_ = false;
  commands_.clear();
  for (const RouteStep& step : router_.route()) commands_.push_back(command_of(step));  // within what was reserved
}

void DynamicMapRouter::drop_route() noexcept {
  commands_.clear();
  next_ = 0;
  no_route_ = false;
  phase_ = Phase::Idle;
}

}  // namespace ganglion
