#include "ganglion/goal/constant/constant.h"

#include <algorithm>
#include <cmath>

#include "ganglion/goal/bid_parameters.h"

namespace ganglion {

Result<std::unique_ptr<ConstantGoal>> ConstantGoal::make(const ConstantGoalConfig& config) {
  if (config.value.empty() || config.value.size() > kMaxCommandValues) {
    return fail(ErrorCode::BadParameter,
                {"value has {} numbers, must have 1 to {}", "value tiene {} números, debe tener de 1 a {}"},
                config.value.size(), kMaxCommandValues);
  }
  if (!std::all_of(config.value.begin(), config.value.end(), [](double v) { return std::isfinite(v); })) {
    return fail(ErrorCode::BadParameter, {"value must be finite numbers", "value debe tener números finitos"});
  }
  return std::unique_ptr<ConstantGoal>(new ConstantGoal(config));
}

ConstantGoal::ConstantGoal(const ConstantGoalConfig& config) noexcept
    : size_(config.value.size()), priority_class_(config.priority_class), intensity_(config.intensity) {
  std::copy(config.value.begin(), config.value.end(), value_.begin());
}

Bid ConstantGoal::bid(const Feedback&) noexcept { return {{value_.data(), size_}, priority_class_, intensity_, false}; }

namespace {

constexpr std::array<double, 1> kZero = {0};

constexpr std::array kParameters = {
    ParameterDescriptor{.name = "value",
                        .type = ParameterType::Reals,
                        .unit = "*",
                        .preset_reals = kZero,
                        .help = {"What is asked for, one number for each value of the request",
                                 "Lo que se solicita, un número por cada valor de la solicitud"},
                        .ours = true},
    kPriorityClass,
    kIntensity,
};

}  // namespace

extern constinit const GlobalGoalKind constant_kind{
    .descriptor = {.component_class = ComponentClass::Goal,
                   .name = "Constant",
                   .summary = {"Wants the same values at every tick", "Quiere siempre los mismos valores"},
                   .parameters = kParameters,
                   .source = "ours"},
    .make = [](const Parameters& parameters) -> Result<std::unique_ptr<GlobalGoal>> {
      auto made = ConstantGoal::make(
          {parameters.reals("value"), parameters.integer("priority_class"), parameters.real("intensity")});
      if (!made) return tl::unexpected<Error>(made.error());
      return std::unique_ptr<GlobalGoal>(std::move(*made));
    }};

}  // namespace ganglion
