#include "ganglion/application/fault/faulty_application.h"

#include <algorithm>
#include <cmath>

#include "ganglion/base/expects.h"
#include "ganglion/base/hash.h"
#include "ganglion/units/angle.h"

namespace ganglion {
namespace {

constexpr double kTimeTolerance_s = 1e-7;  // sums of steps differ from what was written by rounding
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The same direction in [from, from + turn); from 0 on where there is no lowest value.
double within_turn(double value, double min, double turn) noexcept {
  const double from = std::isfinite(min) ? min : 0;
  const double wrapped = value - turn * std::floor((value - from) / turn);
  return wrapped >= from + turn ? from : wrapped;  // a hair below `from`, rounded
}

}  // namespace

FaultPlan::FaultPlan(const Fault& of, FaultSite at, const Description& robot, double step)
    : fault(of), site(std::move(at)), step_s(step) {
  const auto one = [&](double one_dead, double one_min, double one_max, ValueType type, double one_turn) {
    dead.push_back(one_dead);
    min.push_back(one_min);
    max.push_back(one_max);
    circular.push_back(type == ValueType::Circular ? 1 : 0);
    discrete.push_back(type == ValueType::Discrete ? 1 : 0);
    turn.push_back(one_turn);
  };
  for (std::size_t c = 0; site.commands ? c < robot.commands.size() : c < robot.sensations.size(); ++c) {
    if (site.commands) {
      for (const CommandElement& element : robot.commands[c].elements)
        one(element.safe, element.min, element.max, ValueType::Real, 0);
    } else {
      const SensationChannel& channel = robot.sensations[c];
      for (int n = 0; n < channel.size(); ++n) one(channel.dead, channel.min, channel.max, channel.type, channel.turn);
    }
  }
  if (fault.kind == FaultKind::Late) depth = std::max(1.0, std::round(fault.amount / step_s));
}

double FaultPlan::bytes_each() const noexcept {
  const auto width = static_cast<double>(site.values.size());
  const double remembered = (depth + 1) * width + static_cast<double>(site.channels.size());
  return sizeof(FaultAtWork) + remembered * sizeof(double);
}

FaultAtWork::FaultAtWork(std::shared_ptr<const FaultPlan> plan) : plan_(std::move(plan)) {
  const std::size_t width = plan_->site.values.size();
  held_.resize(width);
  held_clocks_.resize(plan_->site.channels.size());
  depth_ = static_cast<std::size_t>(plan_->depth);
  past_.resize(depth_ * width);
}

void FaultAtWork::reset(std::uint64_t seed, std::uint32_t episode, std::uint32_t robot) noexcept {
  stream_ = {seed, episode, robot, hash_name("@fault " + plan_->fault.text())};
  StreamId beginning = stream_;
  beginning.component = combine(stream_.component, hash_name("reset"));
  Draws draws(beginning, 0);
  happens_ = draws.uniform() < plan_->fault.chance;
  from_s_ = plan_->fault.from_latest_s > plan_->fault.from_s
                ? draws.uniform(plan_->fault.from_s, plan_->fault.from_latest_s)
                : plan_->fault.from_s;
  holds_ = false;
  row_ = rows_ = 0;
}

bool FaultAtWork::active(double time_s) const noexcept {
  return happens_ && time_s >= from_s_ - kTimeTolerance_s && time_s < plan_->fault.to_s - kTimeTolerance_s;
}

double FaultAtWork::bounded(std::size_t n, double value) const noexcept {
  const std::size_t at = plan_->site.values[n];
  if (plan_->turn[at] > 0) {
    if (plan_->discrete[at] != 0) value = std::floor(value + 0.5);
    value = within_turn(value, plan_->min[at], plan_->turn[at]);
  } else if (plan_->circular[at] != 0) {
    value = Angle::from_rad(value).wrapped().rad();
  }
  return plan_->min[at] < plan_->max[at] ? std::clamp(value, plan_->min[at], plan_->max[at]) : value;
}

void FaultAtWork::hold(std::span<double> values) noexcept {
  for (std::size_t n = 0; n < plan_->site.values.size(); ++n) {
    double& value = values[plan_->site.values[n]];
    if (holds_) value = held_[n];
    held_[n] = value;
  }
  holds_ = true;
}

void FaultAtWork::shift(std::span<double> values, std::span<double> clocks, bool active) noexcept {
  const std::size_t width = plan_->site.values.size();
  const bool arrived = rows_ >= depth_;
  for (std::size_t n = 0; n < width; ++n) {
    const std::size_t at = plan_->site.values[n];
    double& past = past_[row_ * width + n];
    const double now = values[at];
    if (active) values[at] = arrived ? past : (plan_->site.commands ? plan_->dead[at] : kNaN);
    past = now;
  }
  for (const std::size_t channel : plan_->site.channels) {
    if (active && !plan_->site.commands)
      clocks[channel] +=
          arrived ? static_cast<double>(depth_) * plan_->step_s : std::numeric_limits<double>::infinity();
  }
  row_ = (row_ + 1) % depth_;
  rows_ = std::min(rows_ + 1, depth_);
}

void FaultAtWork::lose(std::span<double> values, std::span<double> clocks, bool lost) noexcept {
  for (std::size_t n = 0; n < plan_->site.values.size(); ++n) {
    const std::size_t at = plan_->site.values[n];
    if (lost) values[at] = holds_ ? held_[n] : (plan_->site.commands ? plan_->dead[at] : kNaN);
    held_[n] = values[at];
  }
  for (std::size_t c = 0; c < plan_->site.channels.size(); ++c) {
    double& clock = clocks[plan_->site.channels[c]];
    if (lost && plan_->site.commands) clock = holds_ ? std::max(0.0, held_clocks_[c] - plan_->step_s) : 0;
    if (lost && !plan_->site.commands)
      clock = holds_ ? held_clocks_[c] + plan_->step_s : std::numeric_limits<double>::infinity();
    held_clocks_[c] = clock;
  }
  holds_ = holds_ || !lost;
}

void FaultAtWork::spoil(std::span<double> values, std::span<double> clocks, std::uint32_t tick,
                        double time_s) noexcept {
  const bool now = active(time_s);
  if (plan_->fault.kind == FaultKind::Late) return shift(values, clocks, now);
  Draws draws(stream_, tick);
  if (plan_->fault.kind == FaultKind::Lost) return lose(values, clocks, now && draws.uniform() < plan_->fault.amount);
  if (!now) {
    holds_ = false;
    return;
  }
  if (plan_->fault.kind == FaultKind::Stuck) return hold(values);
  for (std::size_t n = 0; n < plan_->site.values.size(); ++n) {
    double& value = values[plan_->site.values[n]];
    if (plan_->fault.kind == FaultKind::Dead) value = plan_->dead[plan_->site.values[n]];
    if (plan_->fault.kind == FaultKind::Swapped) std::swap(value, values[plan_->site.with_values[n]]);
    if (!std::isfinite(value)) continue;
    if (plan_->fault.kind == FaultKind::Biased) value = bounded(n, value + plan_->fault.amount);
    if (plan_->fault.kind == FaultKind::Noisy) value = bounded(n, value + plan_->fault.amount * draws.normal());
    if (plan_->fault.kind == FaultKind::Weak) value *= 1 - plan_->fault.amount;
  }
}

Result<std::vector<std::shared_ptr<const FaultPlan>>> plan_faults(const std::vector<Fault>& faults,
                                                                  const Description& robot, int robots, double step_s) {
  expects(step_s > 0);
  if (faults.size() > kMaxFaults)
    return fail_at(faults[kMaxFaults].place, ErrorCode::TooLarge,
                   {"there are {} faults; the limit is {}", "hay {} averías; el límite es {}"}, faults.size(),
                   kMaxFaults);
  std::vector<std::shared_ptr<const FaultPlan>> plans;
  double bytes = 0;
  for (const Fault& fault : faults) {
    auto site = site_of(fault, robot);
    if (!site) return tl::unexpected<Error>(site.error());
    plans.push_back(std::make_shared<const FaultPlan>(fault, std::move(*site), robot, step_s));
    bytes += plans.back()->bytes_each() * robots;
    if (bytes > kMaxFaultBytes)
      return fail_at(fault.place, ErrorCode::TooLarge,
                     {"up to this one the faults of {} robot{} remember {:.0f} MiB; the limit is {:.0f}: take shorter "
                      "delays, fewer faults or fewer robots",
                      "hasta esta, las averías de {} robot{} recuerdan {:.0f} MiB; el límite es {:.0f}: use retrasos "
                      "más cortos, menos averías o menos robots"},
                     robots, robots == 1 ? "" : "s", bytes / (1 << 20), kMaxFaultBytes / (1 << 20));
  }
  return plans;
}

Result<std::unique_ptr<FaultyApplication>> FaultyApplication::make(Application& inner, const std::vector<Fault>& faults,
                                                                   double step_s) {
  const auto plans = plan_faults(faults, inner.description(), inner.robots(), step_s);
  if (!plans) return tl::unexpected<Error>(plans.error());
  std::unique_ptr<FaultyApplication> faulty(new FaultyApplication(inner));
  const auto robots = static_cast<std::size_t>(inner.robots());
  faulty->act_.assign(robots, make_act_frame(inner.description()));
  faulty->faults_.resize(robots);
  for (auto& own : faulty->faults_)
    for (const auto& plan : *plans) own.emplace_back(plan);
  return faulty;
}

Result<void> FaultyApplication::reset(std::uint64_t seed, std::uint32_t episode) {
  for (std::size_t i = 0; i < faults_.size(); ++i)
    for (FaultAtWork& fault : faults_[i]) fault.reset(seed, episode, static_cast<std::uint32_t>(i));
  return inner_.reset(seed, episode);
}

void FaultyApplication::sense(std::span<SenseFrame> frames) noexcept {
  inner_.sense(frames);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    tick_ = frames[i].tick;
    time_s_ = frames[i].time_s;
    for (FaultAtWork& fault : faults_[i])
      if (!fault.on_commands()) fault.spoil(frames[i].values, frames[i].ages_s, tick_, time_s_);
  }
}

void FaultyApplication::step(std::span<const ActFrame> frames, double step_s) noexcept {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    act_[i] = frames[i];  // of equal sizes: takes no memory
    for (FaultAtWork& fault : faults_[i])
      if (fault.on_commands()) fault.spoil(act_[i].values, act_[i].ttl_s, tick_, time_s_);
  }
  inner_.step(act_, step_s);
}

}  // namespace ganglion
