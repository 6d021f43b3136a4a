#pragma once

#include "ganglion/sim/robot/sensor.h"

namespace ganglion::sim {

struct EncodersConfig {
  double resolution_m = 0;  ///< Way of one count; 0 = continuous.
  double left_scale = 1;    ///< Read over true way: wheels of other sizes than thought.
  double right_scale = 1;
  double scatter_m = 0;  ///< Standard deviation of each reading's error after 1 m of way; it grows with the root.
};

/// Counts the turning of both sides. Channels `left`, `right` [m]: way of the rims since the reset, backwards counting
/// negative, cut off to whole counts. Wheels of a robot that is blocked go on turning, and so do the readings; so do
/// those of wheels that slip on a zone of floor. Besides, each side may scatter: its error is a random walk over the
/// way that has gone between firings, of variance scatter^2 times that way.
class Encoders final : public Sensor {
 public:
  explicit Encoders(const EncodersConfig& config) noexcept : config_(config) {}
  bool remembers() const noexcept override { return config_.scatter_m > 0; }
  Limits limits(std::size_t) const noexcept override { return {-1e9, 1e9}; }
  Result<void> reset(const Scene& scene, Draws draws) override;
  bool draws_normal() const noexcept override { return config_.scatter_m > 0; }
  void measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept override;

 private:
  /// One side: the way at its last firing, and how wrong it has become.
  struct Side {
    double way_m = 0;
    double error_m = 0;
  };
  double read_m(Side& side, double way_m, double scale, Draws& draws) const noexcept;

  EncodersConfig config_;
  Side left_, right_;
};

extern const SensorKind encoders_kind;

}  // namespace ganglion::sim
