#pragma once

#include "ganglion/module/component.h"

namespace ganglion {

/// Turns sensations and percepts into percepts (blue in the GFM papers). Runs in every tick, in the order of its wires;
/// an appraisal it receives is the perception that an acting module expected for this tick.
class SensingModule : public Component {
 public:
  void cycle(const Tick& tick) noexcept { perceive(Feedback{tick, links().inputs}); }

 protected:
  /// Writes every output(). Missing readings come in and go out after REP-117.
  virtual void perceive(const Feedback& feedback) noexcept = 0;
};

using SensingModuleKind = Kind<SensingModule>;

}  // namespace ganglion
