#include "ganglion/plant/process/process.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ganglion/math/functions.h"

namespace ganglion {
namespace {

constexpr double kShortestStep_s = 1e-3;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr std::array kTruths = {
    PlantTruth{"value", "", {"value", "valor"}, true},
    PlantTruth{"command", "", {"command that acts", "mando que actúa"}, false},
    PlantTruth{"load", "", {"load", "carga"}, false},
};

}  // namespace

Result<void> Process::judge(ProcessConfig& config) {
  if (!(config.min <= config.max)) {
    return fail(ErrorCode::BadParameter, {"min is {}, must be <= max = {}", "min es {}, debe ser <= max = {}"},
                config.min, config.max);
  }
  if (config.loads.size() != config.load_s.size()) {
    return fail(ErrorCode::BadParameter,
                {"loads has {} numbers and load_s {}: one time for each load is needed",
                 "loads tiene {} números y load_s {}: hace falta un tiempo para cada carga"},
                config.loads.size(), config.load_s.size());
  }
  if (config.loads.size() > kMaxLoads) {
    return fail(ErrorCode::TooLarge,
                {"loads has {} numbers; the limit is {}", "loads tiene {} números; el límite es {}"},
                config.loads.size(), kMaxLoads);
  }
  if (!std::is_sorted(config.load_s.begin(), config.load_s.end())) {
    return fail(ErrorCode::BadParameter, {"load_s must be in order of time", "load_s debe ir por orden de tiempo"});
  }
  return {};
}

double Process::safe() const noexcept { return std::clamp(0.0, config_.min, config_.max); }

CommandElement Process::element(std::size_t) const { return {"command", "", config_.min, config_.max, safe()}; }

std::span<const PlantTruth> Process::truths() const noexcept { return kTruths; }

void Process::reset() {
  time_s_ = 0;
  first_ = value_ = measured_ = config_.start;
  acting_ = safe();
  cost_ = 0;
  sent_.assign(static_cast<std::size_t>(std::ceil(config_.dead_time_s / kShortestStep_s)) + 2, {});
  begin_ = count_ = 0;
}

double Process::load_at(double time_s) const noexcept {
  double load = 0;
  for (std::size_t n = 0; n < config_.load_s.size() && config_.load_s[n] <= time_s; ++n) load = config_.loads[n];
  return load;
}

double Process::next_change_s(double time_s) const noexcept {
  double next_s = count_ > 0 ? sent_[begin_].from_s : kInfinity;
  for (const double load_s : config_.load_s) {
    if (load_s > time_s) return std::min(next_s, load_s);
  }
  return next_s;
}

void Process::send(double command) noexcept {
  if (count_ == sent_.size()) return;  // steps shorter than a millisecond: the earlier command holds on
  sent_[(begin_ + count_) % sent_.size()] = {time_s_ + config_.dead_time_s, command};
  ++count_;
}

void Process::advance(double input, double time_s) noexcept {
  const double goal = config_.gain * input;
  const double lag_s = config_.lag_s, second_s = config_.second_lag_s;
  const double decay = math::exp(-time_s / lag_s);
  const double off = first_ - goal;
  first_ = goal + off * decay;
  if (second_s == 0) {
    value_ = first_;
  } else if (second_s == lag_s) {
    value_ = goal + (value_ - goal + off * time_s / lag_s) * decay;
  } else {
    const double part = off * lag_s / (lag_s - second_s);
    value_ = goal + part * decay + (value_ - goal - part) * math::exp(-time_s / second_s);
  }
}

void Process::step(std::span<const double> commands, double step_s, Draws& draws) noexcept {
  send(commands[0]);
  const double end_s = time_s_ + step_s;
  while (time_s_ < end_s) {
    while (count_ > 0 && sent_[begin_].from_s <= time_s_) {
      acting_ = sent_[begin_].command;
      begin_ = (begin_ + 1) % sent_.size();
      --count_;
    }
    const double until_s = std::min(end_s, next_change_s(time_s_));
    advance(acting_ + load_at(time_s_), until_s - time_s_);
    time_s_ = until_s;
  }
  cost_ = std::fabs(commands[0]) * step_s;
  measured_ = config_.noise > 0 ? value_ + config_.noise * draws.normal() : value_;
}

void Process::tell(std::span<double> truths) const noexcept {
  truths[0] = value_;
  truths[1] = acting_;
  truths[2] = load_at(time_s_);
}

bool Process::failed() const noexcept { return config_.trip > 0 && !(std::fabs(value_) <= config_.trip); }

}  // namespace ganglion
