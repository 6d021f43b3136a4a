#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "ganglion/module/sensing_module.h"

namespace ganglion {

struct CompassDecoderConfig {
  double centre_V = 2.5;
  double amplitude_V = 0.594;
  double least_strength = 0.25;
  double most_strength = 2;
  bool learns = true;
};

/// Range of one of the two voltages over a full turn.
struct VoltageSpan {
  double low_V = std::numeric_limits<double>::infinity();
  double high_V = -std::numeric_limits<double>::infinity();
};

/// The Dinsmore 1655's two voltages to yaw, calibrated by one turn of the robot.
///
/// Feedback  va, vb [V].
/// Output    yaw [rad]; strength: length of the measured vector, 1 = as calibrated; calibrated: 1 once a turn was seen.
/// Missing   NaN, and voltages that no compass gives (strength out of its bounds: cut wire, magnet near): yaw is NaN.
/// Learns    Until calibrated the given centre and amplitude hold. When twelve sectors of 30 deg have been seen, the
///           middle and half the span of each voltage take their place, for good: kept as experience.
/// Phase     From the regions of Nimrod's listing (section 5, SENSORES): its heading is 90 deg where VA is in the
///           middle and VB above, 180 where VB is in the middle and VA below, 270 and 0 in turn. So VA = c + A
///           cos(bearing), VB = c + A sin(bearing), bearing = atan2(VB - c, VA - c) clockwise from north with no
///           rotation, and yaw = 90 deg - bearing. Its 107.14 deg/V = 45 deg / (A sin 45 deg) gives A = 0.594 V.
/// Source    ours (ruling 1.11); midpoints and half spans are the usual hard and soft iron correction along the axes.
class CompassDecoder final : public SensingModule {
 public:
  explicit CompassDecoder(const CompassDecoderConfig& config) noexcept : config_(config) {}

  std::uint32_t experience_version() const noexcept override { return 1; }
  std::span<const PartState> parts() const noexcept override { return {&calibration_, calibrated_ ? 1u : 0u}; }
  void copy(std::size_t part, std::vector<std::byte>& into) const override;
  Result<void> load(std::uint32_t version, std::span<const ExperiencePart> parts) override;

 private:
  void perceive(const Feedback& feedback) noexcept override;
  void learn(double va, double vb, double bearing_rad) noexcept;
  double reduced(double voltage, const VoltageSpan& span) const noexcept;

  CompassDecoderConfig config_;
  VoltageSpan va_{};
  VoltageSpan vb_{};
  std::uint32_t sectors_ = 0;  ///< One bit each.
  bool calibrated_ = false;
  PartState calibration_{"calibration"};
};

extern const SensingModuleKind compass_decoder_kind;

}  // namespace ganglion
