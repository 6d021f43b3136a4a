#pragma once

#include <array>

#include "ganglion/module/global_goal.h"

namespace ganglion {

struct AppConfig {
  double intensity = 1;  ///< In [0, 1].
};

/// The application as trainer: what arrives on one sensation is what the acting module is asked for ("App" in the GFM
/// papers). Other values replace a request that is still pending. What was reached or withdrawn is not asked again
/// until other values come; a missing reading asks for nothing.
///
/// Feedback  request: as many values as the module's request has.
/// Source    "A growing functional modules locomotion subsystem", results, section 5.
class AppGoal final : public GlobalGoal {
 public:
  explicit AppGoal(const AppConfig& config) noexcept : config_(config) {}

  void concluded(RequestStatus status, const Reason& reason) noexcept override;

 private:
  Bid bid(const Feedback& feedback) noexcept override;

  struct Values {
    std::array<double, kMaxCommandValues> data{};
    std::size_t size = 0;
    bool equal(std::span<const double> other) const noexcept;
  };
  AppConfig config_;
  Values wanted_;  ///< Of the last bid.
  Values done_;    ///< Last concluded.
};

}  // namespace ganglion
