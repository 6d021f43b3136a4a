#include "ganglion/goal/constant/constant.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ganglion/goal/bid_parameters.h"

namespace ganglion {

Result<void> ConstantGoal::judge(const ConstantConfig& config) {
  if (config.value.empty() || config.value.size() > kMaxCommandValues) {
    return fail(ErrorCode::BadParameter,
                {"value has {} numbers, must have 1 to {}", "value tiene {} números, debe tener de 1 a {}"},
                config.value.size(), kMaxCommandValues);
  }
  if (!std::all_of(config.value.begin(), config.value.end(), [](double v) { return std::isfinite(v); })) {
    return fail(ErrorCode::BadParameter, {"value must be finite numbers", "value debe tener números finitos"});
  }
  return {};
}

namespace {

constexpr std::array kParameters = {
    parameter<ConstantConfig, &ConstantConfig::value>(
        {.name = "value",
         .title = {"value", "valor"},
         .help = {"What is asked for, one number for each value of the request",
                  "Lo que se solicita, un número por cada valor de la solicitud"},
         .unit = "*",
         .ours = true}),
    intensity_parameter<ConstantConfig>(),
};

}  // namespace

extern constinit const GlobalGoalKind constant_kind{
    .descriptor = {.component_class = ComponentClass::Goal,
                   .name = "Constant",
                   .summary = {"Wants the same values at every tick", "Quiere siempre los mismos valores"},
                   .parameters = kParameters,
                   .source = "ours"},
    .make = make_bound<GlobalGoal, ConstantGoal, ConstantConfig>};

}  // namespace ganglion
