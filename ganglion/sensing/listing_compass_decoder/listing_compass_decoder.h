#pragma once

#include <memory>

#include "ganglion/module/sensing_module.h"

namespace ganglion {

/// The Dinsmore 1655's two voltages as Nimrod's program makes a heading of them, faults included.
///
/// Feedback  va, vb [V].
/// Output    yaw [rad] of the heading variable, compass degrees in [0, 360) clockwise; matched: 1 when one of the five
///           regions fitted at this tick, 0 when the heading is a stale one (0 deg at first).
/// Missing   NaN fits no region: the heading is stale.
/// Source    Alonso, "Desarrollo de un robot con arquitectura de subsuncion (robot Nimrod)", section 5, SENSORES. The
///           five IFs run one after the other, the last that fits wins; 32-bit floats.
/// Faults    kept: near 45 and 225 deg two regions fit at amplitudes below 0.594 V and the wrong one wins by 90 deg; at
///           larger ones no region fits round the four diagonals; the sine is taken as straight, 2 deg off at most.
class ListingCompassDecoder final : public SensingModule {
 public:
  static Result<std::unique_ptr<SensingModule>> make(const Parameters& parameters);

 private:
  void perceive(const Feedback& feedback) noexcept override;
  bool decode(float va, float vb) noexcept;

  float heading_deg_ = 0;
};

extern const SensingModuleKind listing_compass_decoder_kind;

}  // namespace ganglion
