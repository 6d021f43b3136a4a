#include "ganglion/sensing/closing_speed/closing_speed.h"

#include <array>
#include <cmath>

namespace ganglion {
namespace {

using Config = ClosingSpeedConfig;

constexpr double kInstant_s = 1e-6;  // rounding of times that were added up
constexpr double kListingStep_s = 0.3;
constexpr std::array<std::string_view, 2> kPresets = {"recommended", "listing"};

constexpr std::array kPorts = {
    PortDescriptor{.name = "range",
                   .title = {"range", "distancia"},
                   .help = {"Range of a sonar", "Distancia de un sonar"},
                   .unit = "m"},
    PortDescriptor{.name = "speed",
                   .title = {"closing speed", "velocidad de acercamiento"},
                   .help = {"Speed of coming nearer", "Velocidad de acercamiento"},
                   .role = PortRole::Output,
                   .unit = "m/s"},
    PortDescriptor{.name = "acceleration",
                   .title = {"acceleration", "aceleración"},
                   .help = {"Rate of that speed", "Variación de esa velocidad"},
                   .role = PortRole::Output,
                   .unit = "m/s^2"},
};

constexpr std::array kParameters = {
    parameter<Config, &Config::preset>({.name = "preset",
                                        .title = {"preset", "preajuste"},
                                        .help = {"recommended: true time between readings; listing: always 0.3 s",
                                                 "recommended: tiempo real entre lecturas; listing: siempre 0,3 s"},
                                        .choices = kPresets}),
};

}  // namespace

ClosingSpeed::ClosingSpeed(const ClosingSpeedConfig& config) noexcept
    : listing_(config.preset == ClosingSpeedConfig::Preset::Listing) {
  if (!listing_) return;
  range_m_ = 3;
  speed_mps_ = 0;
}

void ClosingSpeed::perceive(const Feedback& feedback) noexcept {
  const double range_m = feedback.value(0);
  const auto ages_s = feedback[0].ages_s;
  const double measured_s = feedback.tick.time_s - (ages_s.empty() ? 0 : ages_s[0]);
  if (!std::isfinite(range_m)) {
    range_m_ = speed_mps_ = acceleration_mps2_ = kUnknown;
  } else if (listing_) {
    differentiate(range_m, kListingStep_s);
  } else if (std::isnan(range_m_) || measured_s > measured_s_ + kInstant_s) {
    differentiate(range_m, measured_s - measured_s_);
    measured_s_ = measured_s;
  }
  publish();
}

void ClosingSpeed::differentiate(double range_m, double dt_s) noexcept {
  const double speed_mps = (range_m_ - range_m) / dt_s;  // NaN until there is something to compare with
  acceleration_mps2_ = (speed_mps - speed_mps_) / dt_s;
  speed_mps_ = speed_mps;
  range_m_ = range_m;
}

void ClosingSpeed::publish() const noexcept {
  put(0, speed_mps_);
  put(1, acceleration_mps2_);
}

extern constinit const SensingModuleKind closing_speed_kind{
    .descriptor = {.component_class = ComponentClass::Sensing,
                   .name = "ClosingSpeed",
                   .summary = {"Speed and acceleration of coming nearer", "Velocidad y aceleración de acercamiento"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "Alonso, robot Nimrod, section 5 (SENSORES: V1NEW, A1)"},
    .make = make_bound<SensingModule, ClosingSpeed, ClosingSpeedConfig>};

}  // namespace ganglion
