#include "ganglion/graph/controller.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace ganglion {
namespace {

/// A robot that hears nothing stops by itself after this time, or one and a half ticks if those are longer.
constexpr double kDefaultTtl_s = 0.3;

}  // namespace

void Controller::tick(const SenseFrame& frame, double step_s, ActFrame& act) noexcept {
  const Tick tick{frame.tick, frame.time_s, step_s};
  const bool priced = frame.cost && std::isfinite(*frame.cost);
  const std::optional<double> cost = priced ? frame.cost : std::nullopt;
  sense(frame);
  run_sensing(tick);
  for (const int index : schedule_.upward) {
    Part& part = parts_[static_cast<std::size_t>(index)];
    gather(part);
    const bool through = part.charged_by >= 0;
    part.acting->settle(through ? parts_[static_cast<std::size_t>(part.charged_by)].acting->last_cost() : cost);
  }
  run_goals(tick);
  run_acting(tick);
  act.tick = frame.tick;
  send(act, step_s);
  grant();
  close(tick);
}

void Controller::sense(const SenseFrame& frame) noexcept {
  expects(frame.values.size() == sense_values_ && frame.ages_s.size() == sense_channels_);
  Block& block = *block_;
  for (Part& part : parts_) {
    if (part.component_class != ComponentClass::Sensation) continue;
    const std::size_t count = part.signals.count - 1;  // the last one is the age
    for (std::size_t i = 0; i < count; ++i) {
      block.now[part.signals.first + i] = frame.values[part.frame_offset + i] + 0.0;  // -0 becomes 0
    }
    const double told_s = frame.ages_s[part.channel];
    const double age_s = told_s >= 0 ? told_s : std::numeric_limits<double>::infinity();
    block.now[part.signals.first + count] = age_s;
    block.ages[part.out_ages.first] = age_s;
    block.ages[part.out_ages.first + 1] = 0;
  }
}

void Controller::gather(Part& part) noexcept {
  Block& block = *block_;
  for (const Copy& copy : part.gather) {
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
  Block& block = *block_;
  for (const int index : schedule_.sensing) {
    Part& part = parts_[static_cast<std::size_t>(index)];
    gather(part);
    part.sensing->cycle(tick);
    double oldest_s = 0;  // a percept is as old as the oldest reading it was made of
    for (const std::size_t age : part.aged_by) oldest_s = std::max(oldest_s, block.ages[age]);
    set_ages(part, oldest_s);
  }
}

void Controller::run_goals(const Tick& tick) noexcept {
  for (const int index : schedule_.goals) gather(parts_[static_cast<std::size_t>(index)]);
  for (Part& part : parts_) {
    if (part.arbiter) part.arbiter->decide(tick, *part.request);
  }
  for (const int index : schedule_.goals) set_ages(parts_[static_cast<std::size_t>(index)], 0);
}

void Controller::run_acting(const Tick& tick) noexcept {
  for (const int index : schedule_.acting) {
    Part& part = parts_[static_cast<std::size_t>(index)];
    gather(part);
    if (part.acting) {
      if (!part.acting->waits()) part.acting->cycle(tick);
    } else {
      coordinate(part, tick);
    }
    publish(part);
  }
}

void Controller::coordinate(Part& part, const Tick& tick) noexcept {
  std::fill(part.shares.begin(), part.shares.end(), 0.0);
  part.command = part.coordinator->coordinate(Feedback{tick, part.views, part.granted}, part.candidates, part.shares);
  const bool acts = part.command.kind == CommandKind::Act;
  for (std::size_t i = 0; i < part.shares.size(); ++i) {  // what did not act had no part, whatever the kind says
    if (!acts || part.candidates[i]->kind != CommandKind::Act) part.shares[i] = 0;
  }
  if (part.below == nullptr) return;
  if (part.command.kind != CommandKind::Act) {
    part.below->clear();
    if (part.command.kind == CommandKind::Withdraw) part.below->withdraw(part.command.reason);
  } else if (part.below->status != RequestStatus::Pending ||
             !std::equal(part.command.span().begin(), part.command.span().end(), part.below->span().begin(),
                         part.below->span().end())) {
    part.below->ask(part.command.span());
  }
}

const Command& Controller::command_of(const Part& part) const noexcept {
  return part.acting ? part.acting->command() : part.command;
}

/// Signals that every acting module and coordinator has: what it is up to and what it commands.
void Controller::publish(Part& part) noexcept {
  Block& block = *block_;
  const Command& command = command_of(part);
  if (part.acting) {
    block.now[part.common] = command.kind == CommandKind::Act ? 1 : 0;
    block.now[part.common + 1] = part.request ? static_cast<double>(part.request->status) : 0;
    block.now[part.common + 2] = part.request ? static_cast<double>(part.request->reason.code) : 0;
  }
  for (std::size_t i = 0; i < part.command_signals.count; ++i) {
    const bool given = command.kind == CommandKind::Act && i < static_cast<std::size_t>(command.size);
    block.now[part.command_signals.first + i] = given ? command.values[i] : 0;
  }
  set_ages(part, 0);
}

/// What becomes of one command channel. Only commands that are numbers, as many as there should be, are carried out;
/// adding zero makes -0 into 0, so that a link, which does not tell them apart, gives the same run.
CommandOrigin Controller::write(const ChannelOut& channel, const Command& command, std::span<double> values) noexcept {
  bool valid = command.kind == CommandKind::Act && command.span().size() == channel.elements.size();
  for (const double value : command.span()) valid = valid && std::isfinite(value);
  for (std::size_t i = 0; i < channel.elements.size(); ++i) {
    const CommandElement& element = channel.elements[i];
    values[i] = valid ? std::clamp(command.values[i], element.min, element.max) + 0.0 : element.safe;
  }
  if (valid) return CommandOrigin::Commanded;
  if (command.kind == CommandKind::Act) return CommandOrigin::Refused;
  return command.kind == CommandKind::Withdraw ? CommandOrigin::Withdrawn : CommandOrigin::Safe;
}

void Controller::send(ActFrame& act, double step_s) noexcept {
  expects(act.values.size() == command_frame_.count && act.origins.size() == channels_.size());
  const Command nothing;
  const double longest_s = std::max(kDefaultTtl_s, 1.5 * step_s);
  for (Part& part : parts_) part.granted = true;
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    const ChannelOut& channel = channels_[c];
    Part* writer = channel.writer >= 0 ? &parts_[static_cast<std::size_t>(channel.writer)] : nullptr;
    const Command& command = writer != nullptr ? command_of(*writer) : nothing;
    act.origins[c] = write(channel, command, std::span(act.values).subspan(channel.offset, channel.elements.size()));
    act.ttl_s[c] = command.ttl_s >= 0 ? std::min(command.ttl_s, longest_s) : longest_s;
    const bool withdrawn = act.origins[c] == CommandOrigin::Withdrawn;
    act.reasons[c] = withdrawn ? static_cast<std::uint16_t>(command.reason.code) : std::uint16_t{0};
    if (writer != nullptr) writer->granted = act.origins[c] == CommandOrigin::Commanded;
  }
  std::copy(act.values.begin(), act.values.end(),
            block_->now.begin() + static_cast<std::ptrdiff_t>(command_frame_.first));
}

/// Consumers come after their candidates in the schedule, so backwards each knows whether it was itself carried out;
/// send() has told those that write to the application.
void Controller::grant() noexcept {
  for (auto index = schedule_.acting.rbegin(); index != schedule_.acting.rend(); ++index) {
    Part& part = parts_[static_cast<std::size_t>(*index)];
    if (part.acting) part.acting->grant(part.granted);
    for (std::size_t i = 0; i < part.candidate_parts.size(); ++i) {
      parts_[static_cast<std::size_t>(part.candidate_parts[i])].granted = part.granted && part.shares[i] > 0;
    }
  }
}

void Controller::close(const Tick& tick) noexcept {
  Block& block = *block_;
  const std::span<const double> values(block.now);
  for (const Part& part : parts_)
    digest_.add(part.digest, tick.number, values.subspan(part.signals.first, part.signals.count));
  digest_.add(command_digest_, tick.number, values.subspan(command_frame_.first, command_frame_.count));
  std::copy_n(block.now.begin(), signals_.size(), block.before.begin());
  for (std::size_t i = 0; i < block.ages.size(); ++i) block.ages_before[i] = block.ages[i] + tick.step_s;
}

const Component* Controller::component(int index) const noexcept {
  const Part& part = parts_[static_cast<std::size_t>(index)];
  if (part.sensing) return part.sensing.get();
  if (part.goal) return part.goal.get();
  if (part.acting) return part.acting.get();
  return part.coordinator.get();
}

void Controller::grow() {
  for (Part& part : parts_) {
    if (part.sensing) part.sensing->grow();
    if (part.goal) part.goal->grow();
    if (part.acting) part.acting->grow();
    if (part.coordinator) part.coordinator->grow();
  }
}

std::vector<ModuleExperience> Controller::experience() const {
  std::vector<ModuleExperience> result;
  for (int i = 0; i < components(); ++i) {
    const Component* one = component(i);
    if (one == nullptr || one->experience_version() == 0) continue;
    ModuleExperience learned{parts_[static_cast<std::size_t>(i)].id,
                             parts_[static_cast<std::size_t>(i)].kind,
                             one->experience_version(),
                             {}};
    one->save(learned.parts);
    result.push_back(std::move(learned));
  }
  return result;
}

void Controller::load(const std::vector<ModuleExperience>& learned, Problems& problems) {
  std::unordered_map<std::string_view, int> learners;  // for look-ups only
  for (int i = 0; i < components(); ++i) {
    if (component(i) != nullptr) learners.emplace(id(i), i);
  }
  for (const ModuleExperience& one : learned) {
    const auto found = learners.find(one.component);
    if (found == learners.end() || parts_[static_cast<std::size_t>(found->second)].kind != one.kind) {
      problems.add({}, ErrorCode::UnknownKey,
                   {"experience of \"{}\" ({}) belongs to no component of this controller",
                    "la experiencia de \"{}\" ({}) no pertenece a ningún componente de este controlador"},
                   one.component, one.kind);
      continue;
    }
    auto* learner = const_cast<Component*>(component(found->second));
    if (auto loaded = learner->load(one.version, one.parts); !loaded) {
      problems.add({}, loaded.error().code, {"{}: {}", "{}: {}"}, one.component, loaded.error().what);
    }
  }
  grow();
}

}  // namespace ganglion
