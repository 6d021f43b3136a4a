#include "ganglion/goal/app/app.h"

#include <algorithm>
#include <cmath>

#include "ganglion/goal/bid_parameters.h"

namespace ganglion {

Bid AppGoal::bid(const Feedback& feedback) noexcept {
  const std::span<const double> values = feedback[0].values;
  const bool finite = std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  if (values.empty() || !finite) return {};
  return {.values = values, .intensity = config_.intensity, .replaces = true, .once = true};
}

namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "request",
                   .title = {"request", "solicitud"},
                   .help = {"What the application asks for; missing readings ask for nothing",
                            "Lo que la aplicación solicita; las lecturas ausentes no solicitan nada"},
                   .role = PortRole::Feedback,
                   .unit = "*",
                   .size = 0}};

constexpr std::array kParameters = {intensity_parameter<AppConfig>()};

}  // namespace

extern constinit const GlobalGoalKind app_kind{
    .descriptor = {.component_class = ComponentClass::Goal,
                   .name = "App",
                   .summary = {"Asks for what the application sends: the application is the trainer",
                               "Solicita lo que envía la aplicación: la aplicación es el entrenador"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "A growing functional modules locomotion subsystem, results, section 5"},
    .make = make_bound<GlobalGoal, AppGoal, AppConfig>};

}  // namespace ganglion
