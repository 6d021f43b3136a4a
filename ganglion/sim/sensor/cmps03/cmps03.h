#pragma once

#include "ganglion/sim/robot/sensor.h"

namespace ganglion::sim {

struct Cmps03Config {
  Angle accuracy = Angle::from_deg(3.5);  ///< Largest bias of a place.
  double local_length_m = 5;              ///< Over which the bias goes through one period, along each axis.
  Angle noise = Angle::from_deg(0.1);     ///< Standard deviation of one reading.
  Angle north = Angle::from_deg(90);      ///< Direction of magnetic north in the world.
};

/// The Devantech CMPS03: bearings in steps of 0.1 deg, right to some 3 to 4 deg once calibrated. Iron in the building
/// bends the field; the bias is a function of the place alone,
///   accuracy (sin(2 pi x / L + a) + sin(2 pi y / L + b)) / 2,   with a and b drawn for each episode (ours),
/// so that it never passes the accuracy, its root mean square over the ground is half of that, and a robot that comes
/// back finds it as it was.
///
/// Channel `heading` [rad]  yaw in the world, counter-clockwise from x, as the other compasses give it.
/// Channel `bearing`        the device's word: tenths of a degree clockwise from north, 0..3599.
/// Source    Devantech CMPS03 documentation: 0-3599 for 0-359.9 deg, accuracy 3-4 deg after calibration.
class Cmps03 final : public Sensor {
 public:
  explicit Cmps03(const Cmps03Config& config) noexcept : config_(config) {}
  Limits limits(std::size_t channel) const noexcept override {
    return channel == 0 ? Limits{-kPi, kPi} : Limits{0, 3599};
  }
  double turn(std::size_t channel) const noexcept override { return channel == 1 ? 3600 : 0; }
  Result<void> reset(const Scene& scene, Draws draws) override;
  void measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept override;

 private:
  double bias_rad(Vector2 place) const noexcept;

  Cmps03Config config_;
  double phase_x_rad_ = 0;
  double phase_y_rad_ = 0;
};

extern const SensorKind cmps03_kind;

}  // namespace ganglion::sim
