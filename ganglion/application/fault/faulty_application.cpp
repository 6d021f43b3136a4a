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

}  // namespace

FaultAtWork::FaultAtWork(const Fault& fault, FaultSite site, const RobotDescription& robot, double step_s)
    : fault_(fault), site_(std::move(site)), step_s_(step_s) {
  const auto one = [&](double dead, double min, double max, bool circular) {
    dead_.push_back(dead);
    min_.push_back(min);
    max_.push_back(max);
    circular_.push_back(circular ? 1 : 0);
  };
  for (std::size_t c = 0; site_.commands ? c < robot.commands.size() : c < robot.sensations.size(); ++c) {
    if (site_.commands) {
      for (const CommandElement& element : robot.commands[c].elements)
        one(element.safe, element.min, element.max, false);
    } else {
      const SensationChannel& channel = robot.sensations[c];
      for (int n = 0; n < channel.size(); ++n)
        one(channel.dead, channel.min, channel.max, channel.type == ValueType::Circular);
    }
  }
  held_.resize(site_.values.size());
  held_clocks_.resize(site_.channels.size());
  if (fault_.kind == FaultKind::Late) {
    depth_ = static_cast<std::size_t>(std::max(1.0, std::round(fault_.amount / step_s)));
    past_.resize(depth_ * site_.values.size());
  }
}

void FaultAtWork::reset(std::uint64_t seed, std::uint32_t episode, std::uint32_t robot) noexcept {
  stream_ = {seed, episode, robot, hash_name("@fault " + fault_.text())};
  StreamId beginning = stream_;
  beginning.component = combine(stream_.component, hash_name("reset"));
  Draws draws(beginning, 0);
  happens_ = draws.uniform() < fault_.chance;
  from_s_ = fault_.from_latest_s > fault_.from_s ? draws.uniform(fault_.from_s, fault_.from_latest_s) : fault_.from_s;
  holds_ = false;
  row_ = rows_ = 0;
}

bool FaultAtWork::active(double time_s) const noexcept {
  return happens_ && time_s >= from_s_ - kTimeTolerance_s && time_s < fault_.to_s - kTimeTolerance_s;
}

double FaultAtWork::bounded(std::size_t n, double value) const noexcept {
  const std::size_t at = site_.values[n];
  if (circular_[at] != 0) value = Angle::from_rad(value).wrapped().rad();
  return min_[at] < max_[at] ? std::clamp(value, min_[at], max_[at]) : value;
}

void FaultAtWork::hold(std::span<double> values) noexcept {
  for (std::size_t n = 0; n < site_.values.size(); ++n) {
    double& value = values[site_.values[n]];
    if (holds_) value = held_[n];
    held_[n] = value;
  }
  holds_ = true;
}

void FaultAtWork::shift(std::span<double> values, std::span<double> clocks, bool active) noexcept {
  const std::size_t width = site_.values.size();
  const bool arrived = rows_ >= depth_;
  for (std::size_t n = 0; n < width; ++n) {
    const std::size_t at = site_.values[n];
    double& past = past_[row_ * width + n];
    const double now = values[at];
    if (active) values[at] = arrived ? past : (site_.commands ? dead_[at] : kNaN);
    past = now;
  }
  for (const std::size_t channel : site_.channels) {
    if (active && !site_.commands)
      clocks[channel] += arrived ? static_cast<double>(depth_) * step_s_ : std::numeric_limits<double>::infinity();
  }
  row_ = (row_ + 1) % depth_;
  rows_ = std::min(rows_ + 1, depth_);
}

void FaultAtWork::lose(std::span<double> values, std::span<double> clocks, bool lost) noexcept {
  for (std::size_t n = 0; n < site_.values.size(); ++n) {
    const std::size_t at = site_.values[n];
    if (lost) values[at] = holds_ ? held_[n] : (site_.commands ? dead_[at] : kNaN);
    held_[n] = values[at];
  }
  for (std::size_t c = 0; c < site_.channels.size(); ++c) {
    double& clock = clocks[site_.channels[c]];
    if (lost && site_.commands) clock = holds_ ? std::max(0.0, held_clocks_[c] - step_s_) : 0;
    if (lost && !site_.commands) clock = holds_ ? held_clocks_[c] + step_s_ : std::numeric_limits<double>::infinity();
    held_clocks_[c] = clock;
  }
  holds_ = holds_ || !lost;
}

void FaultAtWork::spoil(std::span<double> values, std::span<double> clocks, std::uint32_t tick,
                        double time_s) noexcept {
  const bool now = active(time_s);
  if (fault_.kind == FaultKind::Late) return shift(values, clocks, now);
  Draws draws(stream_, tick);
  if (fault_.kind == FaultKind::Lost) return lose(values, clocks, now && draws.uniform() < fault_.amount);
  if (!now) {
    holds_ = false;
    return;
  }
  if (fault_.kind == FaultKind::Stuck) return hold(values);
  for (std::size_t n = 0; n < site_.values.size(); ++n) {
    double& value = values[site_.values[n]];
    if (fault_.kind == FaultKind::Dead) value = dead_[site_.values[n]];
    if (fault_.kind == FaultKind::Swapped) std::swap(value, values[site_.with_values[n]]);
    if (!std::isfinite(value)) continue;
    if (fault_.kind == FaultKind::Biased) value = bounded(n, value + fault_.amount);
    if (fault_.kind == FaultKind::Noisy) value = bounded(n, value + fault_.amount * draws.normal());
    if (fault_.kind == FaultKind::Weak) value *= 1 - fault_.amount;
  }
}

Result<std::unique_ptr<FaultyApplication>> FaultyApplication::make(Application& inner, const std::vector<Fault>& faults,
                                                                   double step_s) {
  expects(step_s > 0);
  std::unique_ptr<FaultyApplication> faulty(new FaultyApplication(inner));
  const RobotDescription& robot = inner.description();
  faulty->act_.assign(static_cast<std::size_t>(inner.robots()), make_act_frame(robot));
  faulty->faults_.resize(static_cast<std::size_t>(inner.robots()));
  for (const Fault& fault : faults) {
    const auto site = site_of(fault, robot);
    if (!site) return tl::unexpected<Error>(site.error());
    for (auto& own : faulty->faults_) own.emplace_back(fault, *site, robot, step_s);
  }
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
