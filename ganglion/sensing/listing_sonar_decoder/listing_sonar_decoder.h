#pragma once

#include <memory>

#include "ganglion/module/sensing_module.h"

namespace ganglion {

/// A PING's echo time as Nimrod's program makes a distance of it, faults included.
///
/// Feedback  echo_time [s], there and back.
/// Output    range [m]: (echo time in whole us / 2) / 29.034 us per cm, the halving that of whole numbers, all in
///           32-bit floats; always finite.
/// Missing   no pulse (0) and NaN give 0 m, as an empty variable does; an endless echo the largest WORD, 65535 us.
/// Source    Alonso, "Desarrollo de un robot con arquitectura de subsuncion (robot Nimrod)", section 5, SENSORES.
class ListingSonarDecoder final : public SensingModule {
 public:
  static Result<std::unique_ptr<SensingModule>> make(const Parameters& parameters);

 private:
  void perceive(const Feedback& feedback) noexcept override;
};

extern const SensingModuleKind listing_sonar_decoder_kind;

}  // namespace ganglion
