#include "ganglion/task/hold/hold.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ganglion {
namespace {

constexpr double kTolerance_s = 1e-9;      // sums of steps differ from multiples by rounding
constexpr std::size_t kMostSteps = 1'000;  // that are kept; later ones are asked for all the same

constexpr std::array kPorts = {
    PortDescriptor{.name = "setpoint",
                   .title = {"set-point", "consigna"},
                   .help = {"The value to be held", "El valor que hay que mantener"},
                   .role = PortRole::Output},
    PortDescriptor{.name = "left_s",
                   .title = {"time left", "tiempo restante"},
                   .help = {"How long it is still asked for; infinite for the last",
                            "Cuánto se seguirá pidiendo; infinito para el último"},
                   .role = PortRole::Output,
                   .unit = "s"},
};
constexpr std::array kParameters = {
    parameter<HoldConfig, &HoldConfig::values>(
        {.name = "values",
         .title = {"set-points", "consignas"},
         .help = {"Values to be held, in order", "Valores que hay que mantener, en orden"},
         .min = -1e9,
         .max = 1e9,
         .ours = true}),
    parameter<HoldConfig, &HoldConfig::each_s>(
        {.name = "each_s",
         .title = {"time of each", "tiempo de cada una"},
         .help = {"How long each is asked for", "Cuánto tiempo se pide cada una"},
         .unit = "s",
         .min = 1e-3,
         .max = 1e6,
         .ours = true}),
    parameter<HoldConfig, &HoldConfig::again>({.name = "again",
                                               .title = {"from the start again", "otra vez desde el principio"},
                                               .help = {"Begins anew after the last; else the last one stays",
                                                        "Vuelve a empezar tras la última; si no, se queda la última"},
                                               .ours = true}),
};

}  // namespace

Result<void> Hold::judge(HoldConfig& config) {
  if (config.values.empty() || config.values.size() > kMaxValues) {
    return fail(ErrorCode::BadParameter,
                {"values has {} set-points, must have 1 to {}", "values tiene {} consignas, debe tener de 1 a {}"},
                config.values.size(), kMaxValues);
  }
  return {};
}

Task::Limits Hold::limits(std::size_t channel) const noexcept {
  if (channel == 1) return {0, std::numeric_limits<double>::infinity()};
  return {std::ranges::min(config_.values), std::ranges::max(config_.values)};
}

std::size_t Hold::turn(double time_s) const noexcept {
  const auto turn = static_cast<std::size_t>(std::floor((time_s + kTolerance_s) / config_.each_s));
  return config_.again ? turn : std::min(turn, config_.values.size() - 1);
}

Result<void> Hold::begin(const Outlook& now, Draws) {
  steps_.list.clear();
  steps_.list.reserve(config_.again ? kMostSteps : config_.values.size());
  steps_.list.push_back({now.time_s, value(0)});
  turn_ = 0;
  steps_.all_set = last(0);
  ++steps_.changed;
  return {};
}

void Hold::judge(const Outlook& now) noexcept {
  const std::size_t next = turn(now.time_s);
  if (next == turn_) return;
  turn_ = next;
  steps_.all_set = last(turn_);
  ++steps_.changed;
  if (steps_.list.size() < kMostSteps) steps_.list.push_back({now.time_s, value(turn_)});
}

void Hold::tell(const Outlook& now, std::span<double> values) const noexcept {
  values[0] = value(turn_);
  values[1] = last(turn_) ? std::numeric_limits<double>::infinity()
                          : static_cast<double>(turn_ + 1) * config_.each_s - now.time_s;
}

LedgerForm Hold::Steps::form() {
  constexpr Text kLine{"set-point {#}: {setpoint}", "consigna {#}: {setpoint}"};
  return {"", {{"time_s", "s", {}}, {"setpoint", "", {}}}, say({"{}", "{}"}, kLine)};
}

std::span<const LedgerColumn> Hold::Steps::columns() const noexcept {
  static const std::vector<LedgerColumn> kColumns = form().columns;
  return kColumns;
}

extern constinit const TaskKind hold_kind{
    .descriptor = {.component_class = ComponentClass::Task,
                   .name = "Hold",
                   .summary = {"Asks for set-points, one after the other", "Pide consignas, una tras otra"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "ours"},
    .make = make_bound<Task, Hold, HoldConfig>};

}  // namespace ganglion
