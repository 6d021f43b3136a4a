#include "ganglion/graph/controller.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ganglion {

using layout::ActingRole;
using layout::CoordinatorRole;
using layout::GoalRole;
using layout::Part;
using layout::SensationRole;
using layout::SensingRole;

namespace {

/// A robot that hears nothing stops by itself after this time, or one and a half ticks if those are longer.
constexpr double kDefaultTtl_s = 0.3;

/// What an acting module or a coordinator commands; nothing of others.
const Command& command_of(const Part& part) noexcept {
  static constexpr Command kNothing{};
  if (const auto* acting = part.as<ActingRole>()) return acting->module->command();
  const auto* coordinator = part.as<CoordinatorRole>();
  return coordinator != nullptr ? coordinator->command : kNothing;
}

}  // namespace

void Controller::tick(const SenseFrame& frame, double step_s, ActFrame& act) noexcept {
  const Tick tick{frame.tick, frame.time_s, step_s};
  const bool priced = frame.cost && std::isfinite(*frame.cost);
  sense(frame);
  run_sensing(tick);
  settle(priced ? frame.cost : std::nullopt);
  run_goals(tick);
  run_acting(tick);
  act.tick = frame.tick;
  send(act, step_s);
  grant();
  close(tick);
}

void Controller::sense(const SenseFrame& frame) noexcept {
  expects(frame.values.size() == sense_values_ && frame.ages_s.size() == sense_channels_);
  layout::Block& block = *block_;
  for (const int index : sensations_) {
    const Part& one = part(index);
    const auto* sensation = one.as<SensationRole>();
    const std::size_t count = one.signals.count - 1;  // the last one is the age
    for (std::size_t i = 0; i < count; ++i) {
      block.now[one.signals.first + i] = frame.values[sensation->frame_offset + i] + 0.0;  // -0 becomes 0
    }
    const double told_s = frame.ages_s[sensation->channel];
    const double age_s = told_s >= 0 ? told_s : std::numeric_limits<double>::infinity();
    block.now[one.signals.first + count] = age_s;
    block.ages[one.out_ages.first] = age_s;
    block.ages[one.out_ages.first + 1] = 0;
  }
}

void Controller::gather(const Part& part) noexcept {
  layout::Block& block = *block_;
  for (const layout::Copy& copy : part.gather) {
    const std::vector<double>& from = copy.previous ? block.before : block.now;
    const std::vector<double>& ages = copy.previous ? block.ages_before : block.ages;
    std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(copy.from), copy.count,
                block.now.begin() + static_cast<std::ptrdiff_t>(copy.to));
    block.ages[copy.age_to] = ages[copy.age_from];
  }
}

void Controller::set_ages(const Part& part, double age_s) noexcept {
  std::fill_n(block_->ages.begin() + static_cast<std::ptrdiff_t>(part.out_ages.first), part.out_ages.count, age_s);
}

void Controller::run_sensing(const Tick& tick) noexcept {
  for (const int index : schedule_.sensing) {
    const Part& one = part(index);
    gather(one);
    const auto& sensing = *one.as<SensingRole>();
    sensing.module->cycle(tick);
    double oldest_s = 0;  // a percept is as old as the oldest reading it was made of
    for (const std::size_t age : sensing.aged_by) oldest_s = std::max(oldest_s, block_->ages[age]);
    set_ages(one, oldest_s);
  }
}

void Controller::settle(std::optional<double> cost) noexcept {
  for (const int index : schedule_.upward) {
    const Part& one = part(index);
    gather(one);
    const auto& acting = *one.as<ActingRole>();
    const bool through = acting.charged_by >= 0;
    acting.module->settle(through ? part(acting.charged_by).as<ActingRole>()->module->last_cost() : cost);
  }
}

/// What became of requests is told first; then each goal says once what it wants, however many modules it asks.
void Controller::run_goals(const Tick& tick) noexcept {
  for (const int index : asked_by_goals_) {
    auto& acting = *part(index).as<ActingRole>();
    acting.arbiter->conclude(tick, *acting.request);
  }
  for (const int index : schedule_.goals) {
    gather(part(index));
    part(index).as<GoalRole>()->goal->decide(tick);
  }
  for (const int index : asked_by_goals_) {
    auto& acting = *part(index).as<ActingRole>();
    acting.arbiter->decide(tick, *acting.request);
  }
  for (const int index : schedule_.goals) publish_goal(part(index), tick);
}

void Controller::run_acting(const Tick& tick) noexcept {
  for (const int index : schedule_.acting) {
    Part& one = part(index);
    gather(one);
    if (const auto* acting = one.as<ActingRole>()) {
      if (!acting->module->waits()) acting->module->cycle(tick);
    } else {
      coordinate(one, tick);
    }
    publish(one);
  }
}

void Controller::coordinate(Part& part, const Tick& tick) noexcept {
  auto& role = *part.as<CoordinatorRole>();
  std::fill(role.shares.begin(), role.shares.end(), 0.0);
  role.command = role.coordinator->coordinate(Feedback{tick, part.views, part.share}, role.candidates, role.shares);
  const bool acts = role.command.kind == CommandKind::Act;
  for (std::size_t i = 0; i < role.shares.size(); ++i) {  // what did not act had no part, whatever the kind says
    if (!acts || role.candidates[i]->kind != CommandKind::Act) role.shares[i] = 0;
  }
  if (role.below == nullptr) return;
  if (acts) {
    role.below->keep_asking(role.command.span(), role.command.ttl_s);
    return;
  }
  role.below->clear();
  if (role.command.kind == CommandKind::Withdraw) role.below->withdraw(role.command.reason);
}

/// Signals that every acting module and coordinator has: what it is up to and what it commands.
void Controller::publish(const Part& part) noexcept {
  if (part.as<ActingRole>() != nullptr) publish_acting(part);
  if (part.as<CoordinatorRole>() != nullptr) publish_shares(part);
  const Command& command = command_of(part);
  for (std::size_t i = 0; i < part.command_signals.count; ++i) {
    const bool given = command.kind == CommandKind::Act && i < static_cast<std::size_t>(command.size);
    block_->now[part.command_signals.first + i] = given ? command.values[i] : 0;
  }
  set_ages(part, 0);
}

void Controller::publish_acting(const Part& part) noexcept {
  enum Common : std::size_t { kActive, kStatus, kReason, kSettled };
  const auto& acting = *part.as<ActingRole>();
  std::vector<double>& now = block_->now;
  now[part.common_at[kActive]] = acting.module->command().kind == CommandKind::Act ? 1 : 0;
  now[part.common_at[kStatus]] = acting.request ? static_cast<double>(acting.request->status) : 0;
  now[part.common_at[kReason]] = acting.request ? static_cast<double>(acting.request->reason.code) : 0;
  if (part.common_at.size() > kSettled) now[part.common_at[kSettled]] = acting.module->is_settled() ? 1 : 0;
}

/// Who drives, who wanted to and who could not: the candidate with the largest part counts as the one that drives.
void Controller::publish_shares(const Part& part) noexcept {
  enum Common : std::size_t { kActive, kShare, kWanted, kSuppressed };
  const auto& role = *part.as<CoordinatorRole>();
  std::vector<double>& now = block_->now;
  std::size_t most = 0;
  for (std::size_t i = 0; i < role.shares.size(); ++i) {
    const bool wants = role.candidates[i]->kind == CommandKind::Act;
    if (role.shares[i] > role.shares[most]) most = i;
    now[part.common_at[kShare] + i] = role.shares[i];
    now[part.common_at[kWanted] + i] = wants ? 1 : 0;
    now[part.common_at[kSuppressed] + i] = wants && role.shares[i] == 0 ? 1 : 0;
  }
  const bool any = !role.shares.empty() && role.shares[most] > 0;
  now[part.common_at[kActive]] = any ? static_cast<double>(most) : -1;
}

void Controller::publish_goal(const Part& part, const Tick& tick) noexcept {
  enum Common : std::size_t { kIntensity, kHolds, kRests };
  const auto& role = *part.as<GoalRole>();
  bool holds = false;
  std::uint32_t rests = 0;
  for (const auto& [module, member] : role.asks) {
    const GoalArbiter& arbiter = *this->part(module).as<ActingRole>()->arbiter;
    holds = holds || arbiter.holds(member);
    rests = std::max(rests, arbiter.rests(member, tick));
  }
  const Bid& wanted = role.goal->wanted();
  block_->now[part.common_at[kIntensity]] = wanted.values.empty() ? 0 : wanted.intensity;
  block_->now[part.common_at[kHolds]] = holds ? 1 : 0;
  block_->now[part.common_at[kRests]] = rests * tick.step_s;
  set_ages(part, 0);
}

/// What becomes of one command channel. Only commands that are numbers, as many as there should be, are carried out;
/// adding zero makes -0 into 0, so that a link, which does not tell them apart, gives the same run.
CommandOrigin Controller::write(const layout::ChannelOut& channel, const Command& command,
                                std::span<double> values) noexcept {
  bool valid = command.kind == CommandKind::Act && command.span().size() == channel.elements.size();
  for (const double value : command.span()) valid = valid && std::isfinite(value);
  for (std::size_t i = 0; i < channel.elements.size(); ++i) {
    const CommandElement& element = channel.elements[i];
    values[i] = valid ? std::clamp(command.values[channel.from[i]], element.min, element.max) + 0.0 : element.safe;
  }
  if (valid) return CommandOrigin::Commanded;
  if (command.kind == CommandKind::Act) return CommandOrigin::Refused;
  return command.kind == CommandKind::Withdraw ? CommandOrigin::Withdrawn : CommandOrigin::Safe;
}

void Controller::send(ActFrame& act, double step_s) noexcept {
  expects(act.values.size() == command_frame_.count && act.origins.size() == channels_.size());
  const Command nothing;
  const double longest_s = std::max(kDefaultTtl_s, 1.5 * step_s);
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    const layout::ChannelOut& channel = channels_[c];
    Part* writer = channel.writer >= 0 ? &part(channel.writer) : nullptr;
    const Command& command = writer != nullptr ? command_of(*writer) : nothing;
    act.origins[c] = write(channel, command, std::span(act.values).subspan(channel.offset, channel.elements.size()));
    act.ttl_s[c] = command.ttl_s >= 0 ? std::min(command.ttl_s, longest_s) : longest_s;
    const bool withdrawn = act.origins[c] == CommandOrigin::Withdrawn;
    act.reasons[c] = withdrawn ? static_cast<std::uint16_t>(command.reason.common().code) : std::uint16_t{0};
    if (writer != nullptr) writer->share = act.origins[c] == CommandOrigin::Commanded ? 1 : 0;
  }
  std::copy(act.values.begin(), act.values.end(),
            block_->now.begin() + static_cast<std::ptrdiff_t>(command_frame_.first));
}

/// Consumers come after their candidates in the schedule, so backwards each knows what part of its command was carried
/// out; send() has told those that write to the application.
void Controller::grant() noexcept {
  for (auto index = schedule_.acting.rbegin(); index != schedule_.acting.rend(); ++index) {
    const Part& one = part(*index);
    if (const auto* acting = one.as<ActingRole>()) acting->module->carried_out(one.share);
    const auto* coordinator = one.as<CoordinatorRole>();
    for (std::size_t i = 0; coordinator != nullptr && i < coordinator->candidate_parts.size(); ++i) {
      part(coordinator->candidate_parts[i]).share = one.share * coordinator->shares[i];
    }
  }
}

void Controller::close(const Tick& tick) noexcept {
  layout::Block& block = *block_;
  const std::span<const double> values(block.now);
  for (const layout::Digested& one : digested_)
    digest_.add(one.component, tick.number, values.subspan(one.values.first, one.values.count));
  std::copy_n(block.now.begin(), signals_.size(), block.before.begin());
  for (std::size_t i = 0; i < block.ages.size(); ++i) block.ages_before[i] = block.ages[i] + tick.step_s;
}

const ActingModule* Controller::acting(int index) const noexcept {
  const auto* acting = part(index).as<ActingRole>();
  return acting != nullptr ? acting->module : nullptr;
}

const RequestSlot* Controller::request(int index) const noexcept {
  const auto* acting = part(index).as<ActingRole>();
  return acting != nullptr ? acting->request.get() : nullptr;
}

void Controller::grow() {
  for (const Part& part : parts_) {
    if (part.component != nullptr) part.component->grow();
  }
}

}  // namespace ganglion
