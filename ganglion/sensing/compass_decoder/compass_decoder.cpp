#include "ganglion/sensing/compass_decoder/compass_decoder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ganglion/math/functions.h"
#include "ganglion/sensing/compass_voltages.h"
#include "ganglion/units/angle.h"

namespace ganglion {
namespace {

using Config = CompassDecoderConfig;

enum Output : std::size_t { kYaw, kStrength, kCalibrated };

constexpr int kSectors = 12;
constexpr std::uint32_t kAllSectors = (1U << kSectors) - 1;
constexpr double kMost_V = 1000;  // beyond any real device: a damaged file

constexpr std::array kPorts = {
    kCosineVoltage,
    kSineVoltage,
    PortDescriptor{.name = "yaw",
                   .title = {"yaw", "ángulo"},
                   .help = {"Yaw, counter-clockwise from east", "Ángulo, antihorario desde el este"},
                   .role = PortRole::Output,
                   .unit = "rad",
                   .type = ValueType::Circular},
    PortDescriptor{.name = "strength",
                   .title = {"strength", "intensidad"},
                   .help = {"Length of the measured vector, 1 = as calibrated",
                            "Longitud del vector medido, 1 = según calibración"},
                   .role = PortRole::Output},
    PortDescriptor{.name = "calibrated",
                   .title = {"calibrated", "calibrada"},
                   .help = {"1 once a full turn was seen", "1 tras ver una vuelta completa"},
                   .role = PortRole::Output,
                   .type = ValueType::Discrete},
};

constexpr std::array kParameters = {
    parameter<Config, &Config::centre_V>({.name = "centre_V",
                                          .title = {"centre voltage", "voltaje central"},
                                          .help = {"Middle voltage until calibrated", "Voltaje medio hasta calibrar"},
                                          .unit = "V",
                                          .min = 0,
                                          .max = 24,
                                          .live = true}),
    parameter<Config, &Config::amplitude_V>(
        {.name = "amplitude_V",
         .title = {"amplitude", "amplitud"},
         .help = {"Amplitude until calibrated: the one that the listing's 107.14 deg/V fits",
                  "Amplitud hasta calibrar: la que encaja con los 107,14 grados/V del programa"},
         .unit = "V",
         .min = 0.001,
         .max = 24,
         .ours = true,
         .live = true}),
    parameter<Config, &Config::least_strength>(
        {.name = "least_strength",
         .title = {"least strength", "intensidad mínima"},
         .help = {"A weaker vector is no heading", "Un vector más débil no da rumbo"},
         .min = 0,
         .max = 1,
         .ours = true,
         .live = true}),
    parameter<Config, &Config::most_strength>(
        {.name = "most_strength",
         .title = {"most strength", "intensidad máxima"},
         .help = {"A stronger vector is no heading", "Un vector más fuerte no da rumbo"},
         .min = 1,
         .max = 100,
         .ours = true,
         .live = true}),
    parameter<Config, &Config::learns>(
        {.name = "learn",
         .title = {"calibration", "calibración"},
         .help = {"Calibrate by the first full turn", "Calibrar con la primera vuelta completa"},
         .ours = true}),
};

bool plausible(const VoltageSpan& span) noexcept {
  return std::fabs(span.low_V) < kMost_V && std::fabs(span.high_V) < kMost_V && span.low_V < span.high_V;
}

}  // namespace

void CompassDecoder::perceive(const Feedback& feedback) noexcept {
  const double va = feedback.value(0);
  const double vb = feedback.value(1);
  const double cosine = reduced(va, va_);
  const double sine = reduced(vb, vb_);
  const double strength = math::hypot(cosine, sine);
  double yaw_rad = std::numeric_limits<double>::quiet_NaN();
  if (strength >= config_.least_strength && strength <= config_.most_strength) {  // false for NaN
    const double bearing_rad = math::atan2(sine, cosine);
    yaw_rad = wrap_rad(kPi / 2 - bearing_rad);
    if (config_.learns && !calibrated_) learn(va, vb, bearing_rad);
  }
  put(kYaw, yaw_rad);
  put(kStrength, strength);
  put(kCalibrated, calibrated_ ? 1 : 0);
}

void CompassDecoder::learn(double va, double vb, double bearing_rad) noexcept {
  va_ = {std::min(va_.low_V, va), std::max(va_.high_V, va)};
  vb_ = {std::min(vb_.low_V, vb), std::max(vb_.high_V, vb)};
  const int sector = static_cast<int>(std::floor((bearing_rad + kPi) / (2 * kPi) * kSectors));
  sectors_ |= 1U << std::clamp(sector, 0, kSectors - 1);
  calibrated_ = sectors_ == kAllSectors;
}

double CompassDecoder::reduced(double voltage, const VoltageSpan& span) const noexcept {
  if (!calibrated_) return (voltage - config_.centre_V) / config_.amplitude_V;
  return (2 * voltage - span.low_V - span.high_V) / (span.high_V - span.low_V);
}

void CompassDecoder::copy(std::size_t, std::vector<std::byte>& into) const {
  ByteWriter writer(std::move(into));
  for (const double voltage : {va_.low_V, va_.high_V, vb_.low_V, vb_.high_V}) writer.f64(voltage);
  into = writer.take();
}

Result<void> CompassDecoder::load(std::uint32_t version, std::span<const ExperiencePart> parts) {
  if (version != 1)
    return fail(ErrorCode::Unsupported,
                {"calibration of version {}, this program knows 1",
                 "la calibración es de la versión {}; este programa conoce la 1"},
                version);
  for (const ExperiencePart& part : parts) {
    if (part.name != calibration_.name) continue;
    ByteReader reader(part.bytes);
    VoltageSpan va{reader.f64(), reader.f64()};
    VoltageSpan vb{reader.f64(), reader.f64()};
    if (!reader.complete() || !plausible(va) || !plausible(vb)) {
      return fail(ErrorCode::Corrupt,
                  {"calibration is damaged: {} bytes, must be 4 voltages, low < high",
                   "la calibración está dañada: {} bytes, deben ser 4 voltajes, mínimo < máximo"},
                  part.bytes.size());
    }
    va_ = va;
    vb_ = vb;
    calibrated_ = true;
    ++calibration_.generation;
  }
  return {};
}

extern constinit const SensingModuleKind compass_decoder_kind{
    .descriptor = {.component_class = ComponentClass::Sensing,
                   .name = "CompassDecoder",
                   .summary = {"Two voltages of an analogue compass to yaw, calibrated by one turn",
                               "Dos voltajes de una brújula analógica a ángulo, calibrada con una vuelta"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "ours"},
    .make = make_bound<SensingModule, CompassDecoder, CompassDecoderConfig>};

}  // namespace ganglion
