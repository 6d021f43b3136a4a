// How the module fits its map to what its last step brought about (internalAdaptation in the papers).
#include <cmath>
#include <limits>
#include <numbers>

#include "ganglion/acting/dynamic_map_router/dynamic_map_router.h"
#include "ganglion/units/angle.h"

namespace ganglion {
namespace {

using grid::CellIndex;
using grid::Label;
using grid::RouteStep;

/// A whole number within the map's reach, or nothing.
std::optional<std::int32_t> whole(double value) noexcept {
  if (!(std::fabs(value) < grid::kFarthestCell)) return std::nullopt;
  return static_cast<std::int32_t>(std::floor(value + 0.5));
}

int eighths(double heading_rad) noexcept {
  const double turns = std::fmod(heading_rad, 2 * kPi) / (kPi / 4);
  return static_cast<int>(std::floor(turns + 0.5)) & 7;
}

double suspicion(const grid::RiskMap& map, CellIndex index) noexcept {
  const grid::Cell* cell = map.find(index);
  return cell == nullptr || cell->label == Label::Unexplored ? map.rule().first_risk : cell->risk;
}

bool known_empty(const grid::RiskMap& map, CellIndex index) noexcept {
  const grid::Cell* cell = map.find(index);
  return cell != nullptr && cell->label == Label::Empty;
}

struct Blame {
  CellIndex cell{};
  bool certain = true;  ///< Every other cell that the step needed is known to be empty.
};

/// The likeliest cause of a failed step: its cell, or of a diagonal one also the cells beside it. Of equally suspect
/// ones the cell itself, then the first in row order.
Blame blame(const grid::RiskMap& map, const RouteStep& step) noexcept {
  if (!grid::is_diagonal(step.direction)) return {step.to};
  CellIndex first = neighbour(step.from, grid::turned(step.direction, -1));
  CellIndex second = neighbour(step.from, grid::turned(step.direction, 1));
  if (second.row < first.row || (second.row == first.row && second.column < first.column)) std::swap(first, second);
  Blame result{step.to};
  for (const CellIndex side : {first, second}) {
    if (suspicion(map, side) > suspicion(map, result.cell)) result.cell = side;
  }
  for (const CellIndex other : {step.to, first, second}) {
    if (other != result.cell && !known_empty(map, other)) result.certain = false;
  }
  return result;
}

/// The module below gave the step up for a reason that lies not in the ground.
bool tells_nothing(const Feedback& feedback) noexcept {
  if (feedback.outcome != RequestStatus::Withdrawn) return false;
  const ReasonCode code = feedback.reason.code;
  return code == ReasonCode::NoReading || code == ReasonCode::BadRequest || code == ReasonCode::Preempted;
}

}  // namespace

void DynamicMapRouter::internal_adaptation(const Feedback& feedback, Cost cost) noexcept {
  attend(feedback, cost.value);
  publish(Phase::Idle, feedback);  // propagation, where a request calls for it, publishes what it does
}

void DynamicMapRouter::attend(const Feedback& feedback, double cost_j) noexcept {
  if (attended_ == feedback.tick.number) return;
  attended_ = feedback.tick.number;
  ++now_;
  if (attempt_ && std::isfinite(cost_j) && cost_j >= 0) {
    attempt_cost_j_ += cost_j;
    attempt_costed_ = true;
  }
  if (!feedback.granted() || tells_nothing(feedback)) attempt_.reset();
  locate(feedback);
}

void DynamicMapRouter::locate(const Feedback& feedback) noexcept {
  const PortView& reading = feedback[kCell];
  const auto column = reading.wired() ? whole(reading.values[0]) : std::nullopt;
  const auto row = reading.wired() ? whole(reading.values[1]) : std::nullopt;
  const double heading_rad = feedback.value(kHeading);
  cell_read_ = column && row;
  if (std::isfinite(heading_rad)) {
    heading_ = eighths(heading_rad);
  } else if (cell_read_ && attempt_ && attempt_->to == CellIndex{*column, *row}) {
    heading_ = attempt_->heading;  // a lost compass: the step was driven, so the heading is the one it needed
  }
  if (!cell_read_) return;  // the outcome of the step shows when readings return
  const CellIndex before = cell_.value_or(CellIndex{*column, *row});
  cell_ = CellIndex{*column, *row};
  if (attempt_) {
    conclude_attempt(feedback.value(kContact) == 0);
  } else if (before != *cell_) {
    trail_.clear();
    no_route_ = false;
  }
  map_.visit(*cell_);
}

void DynamicMapRouter::conclude_attempt(bool untouched) noexcept {
  const RouteStep step = *attempt_;
  attempt_.reset();
  if (*cell_ == step.to) {
    note_arrival(step);
  } else if (steps_between(*cell_, step.from) > 1) {
    no_route_ = false;  // carried off: that tells nothing about the step
  } else {
    note_failure(step, untouched);
  }
  if (*cell_ != step.to && *cell_ != step.from) trail_.clear();
}

void DynamicMapRouter::note_arrival(const RouteStep& step) noexcept {
  map_.visit(step.from);
  if (!known_empty(map_, step.to)) rounds_ = 0;  // the map got better: worth another set of rounds
  map_.cross(step.to);
  const double length = grid::is_diagonal(step.direction) ? std::numbers::sqrt2 : 1;
  if (attempt_costed_) map_.book_cost(step.to, attempt_cost_j_ / length);
  if (phase_ == Phase::GoBack) {
    trail_.pop();
  } else {
    trail_.push(step);
    ++next_;
  }
}

void DynamicMapRouter::note_failure(const RouteStep& step, bool untouched) noexcept {
  const Blame found = blame(map_, step);
  const auto certain = untouched ? grid::FailureCause::Untouched : grid::FailureCause::Cell;
  tried_[attempts_++ % tried_.size()] = {*cell_, found.certain ? found.cell : step.to};
  ++failures_;
  if (found.certain) return map_.fail(found.cell, now_, certain);
  // Nobody knows yet that an unexplored cell is to blame: calling it occupied would close free ground to secure routes.
  const grid::Cell* cell = map_.find(found.cell);
  if (cell != nullptr && cell->label != Label::Unexplored) map_.fail(found.cell, now_, grid::FailureCause::Unclear);
  map_.fail_diagonal(step.from, step.direction);
}

void DynamicMapRouter::expected_feedback(std::span<double> appraisal) const noexcept {
  const bool known = (attempt_ || cell_) && appraisal.size() >= 2;
  std::fill(appraisal.begin(), appraisal.end(), std::numeric_limits<double>::quiet_NaN());
  if (!known) return;
  const CellIndex expected = attempt_ ? attempt_->to : *cell_;
  appraisal[0] = expected.column;
  appraisal[1] = expected.row;
}

}  // namespace ganglion
