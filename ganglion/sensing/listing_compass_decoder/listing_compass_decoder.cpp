#include "ganglion/sensing/listing_compass_decoder/listing_compass_decoder.h"

#include <array>

#include "ganglion/sensing/compass_voltages.h"
#include "ganglion/units/angle.h"

namespace ganglion {
namespace {

constexpr std::array kPorts = {
    kCosineVoltage,
    kSineVoltage,
    PortDescriptor{.name = "yaw",
                   .title = {"yaw", "ángulo"},
                   .help = {"Yaw of the listing's heading", "Ángulo del rumbo del programa"},
                   .role = PortRole::Output,
                   .unit = "rad",
                   .type = ValueType::Circular},
    PortDescriptor{.name = "matched",
                   .title = {"matched", "encaja"},
                   .help = {"1 when a region fitted, 0 when the heading is stale",
                            "1 si alguna región encajó, 0 si el rumbo es viejo"},
                   .role = PortRole::Output,
                   .type = ValueType::Discrete},
};

}  // namespace

Result<std::unique_ptr<SensingModule>> ListingCompassDecoder::make(const Parameters&) {
  return std::make_unique<ListingCompassDecoder>();
}

void ListingCompassDecoder::perceive(const Feedback& feedback) noexcept {
  const bool matched = decode(static_cast<float>(feedback.value(0)), static_cast<float>(feedback.value(1)));
  put(0, yaw_from_compass_deg(static_cast<double>(heading_deg_)).rad());
  put(1, matched ? 1 : 0);
}

/// The five regions in the order of the program.
bool ListingCompassDecoder::decode(float va, float vb) noexcept {
  const float gradient = va - vb + 10.0F;
  const bool va_in_band = va >= 2.08F && va <= 2.92F;
  const bool vb_in_band = vb >= 2.08F && vb <= 2.92F;
  bool matched = false;
  const auto set = [&](float heading_deg) {
    heading_deg_ = heading_deg;
    matched = true;
  };
  if (va_in_band && gradient <= 10.0F) set(45.0F + 107.14F * (2.92F - va));
  if (va_in_band && gradient >= 10.0F) set(225.0F + 107.14F * (va - 2.08F));
  if (vb_in_band && gradient <= 10.0F) set(135.0F + 107.14F * (2.92F - vb));
  if (vb_in_band && vb >= 2.5F && gradient >= 10.0F) set(107.14F * (vb - 2.5F));
  if (vb_in_band && vb < 2.5F && gradient >= 10.0F) set(315.0F + 107.14F * (vb - 2.08F));
  return matched;
}

extern constinit const SensingModuleKind listing_compass_decoder_kind{
    .descriptor = {.component_class = ComponentClass::Sensing,
                   .name = "ListingCompassDecoder",
                   .summary = {"Two compass voltages to a heading exactly as in Nimrod's listing",
                               "Dos voltajes de brújula a rumbo tal como en el programa de Nimrod"},
                   .ports = kPorts,
                   .source = "Alonso, robot Nimrod, section 5 (SENSORES)"},
    .make = ListingCompassDecoder::make};

}  // namespace ganglion
