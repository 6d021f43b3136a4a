#pragma once

#include "ganglion/module/global_goal.h"

namespace ganglion {

struct AppConfig {
  double intensity = 1;  ///< In [0, 1].
};

/// The application as trainer: what arrives on one sensation is what the acting module is asked for ("App" in the GFM
/// papers). Other values replace a request that is still pending; a missing reading asks for nothing. The same values are
/// asked again when what was reached holds no more (the robot was carried off, or had believed itself there), or was
/// withdrawn and the goal has rested (ours; the papers say nothing of a wish that stands).
///
/// Feedback  request: as many values as the module's request has.
/// Source    "A growing functional modules locomotion subsystem", results, section 5.
class AppGoal final : public GlobalGoal {
 public:
  explicit AppGoal(const AppConfig& config) noexcept : config_(config) {}

 private:
  Bid bid(const Feedback& feedback) noexcept override;

  AppConfig config_;
};

}  // namespace ganglion
