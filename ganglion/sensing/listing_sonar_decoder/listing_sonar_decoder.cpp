#include "ganglion/sensing/listing_sonar_decoder/listing_sonar_decoder.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ganglion {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{
        .name = "echo_time",
        .title = {"echo time", "tiempo de eco"},
        .help = {"Time of the echo, there and back; 0 = no pulse", "Tiempo del eco, ida y vuelta; 0 = sin pulso"},
        .unit = "s"},
    PortDescriptor{
        .name = "range",
        .title = {"range", "distancia"},
        .help = {"Distance as the listing computes it; 0 without a pulse", "Distancia según el programa; 0 sin pulso"},
        .role = PortRole::Output,
        .unit = "m"},
};

}  // namespace

Result<std::unique_ptr<SensingModule>> ListingSonarDecoder::make(const Parameters&) {
  return std::make_unique<ListingSonarDecoder>();
}

void ListingSonarDecoder::perceive(const Feedback& feedback) noexcept {
  const double echo_s = feedback.value(0);
  const double echo_us = std::isnan(echo_s) ? 0 : std::clamp(std::floor(echo_s * 1e6 + 0.5), 0.0, 65535.0);
  const int way_us = static_cast<int>(echo_us) / 2;
  const float distance_cm = static_cast<float>(way_us) / 29.034F;
  put(0, static_cast<double>(distance_cm) / 100);
}

extern constinit const SensingModuleKind listing_sonar_decoder_kind{
    .descriptor = {.component_class = ComponentClass::Sensing,
                   .name = "ListingSonarDecoder",
                   .summary = {"Echo time to distance exactly as in Nimrod's listing",
                               "Tiempo de eco a distancia tal como en el programa de Nimrod"},
                   .ports = kPorts,
                   .source = "Alonso, robot Nimrod, section 5 (SENSORES)"},
    .make = ListingSonarDecoder::make};

}  // namespace ganglion
