#include "ganglion/goal/app/app.h"

#include <algorithm>
#include <cmath>

#include "ganglion/goal/bid_parameters.h"

namespace ganglion {

bool AppGoal::Values::equal(std::span<const double> other) const noexcept {
  return std::equal(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(size), other.begin(), other.end());
}

Bid AppGoal::bid(const Feedback& feedback) noexcept {
  const std::span<const double> values = feedback[0].values;
  const bool finite = std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  if (values.empty() || values.size() > wanted_.data.size() || !finite) return {};
  if (done_.equal(values)) return {};
  std::copy(values.begin(), values.end(), wanted_.data.begin());
  wanted_.size = values.size();
  done_ = {};  // once the trainer has asked for something else, the old wish may be asked again
  return {{wanted_.data.data(), wanted_.size}, config_.intensity, true};
}

void AppGoal::concluded(RequestStatus, const Reason& reason) noexcept {
  if (reason.code != ReasonCode::Preempted) done_ = wanted_;  // what another goal cut short is still wanted
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
