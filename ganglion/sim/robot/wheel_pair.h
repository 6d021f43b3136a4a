#pragma once

#include "ganglion/sim/robot/drive.h"
#include "ganglion/sim/robot/first_order_lag.h"

namespace ganglion::sim {

struct WheelPairConfig {
  double full_scale_mps = 0.2;  ///< Speed of a rim at duty 1.
  double track_m = 0.18;        ///< Effective distance of the two contact lines: turn rate = (right - left) / track.
  double dead_zone = 0;         ///< Duties of less do not move a wheel; others are not shifted by it.
  double left_gain = 1;         ///< What a side makes of its duty: unequal motors.
  double right_gain = 1;
  double lag_s = 0;  ///< Time constant of both motors.
};

/// Two driven sides under duties in [-1, 1]: what differential and tracked drives share. Speeds follow the duties with
/// a first-order lag; a sub-step is the exact arc of its mean speeds.
class WheelPair {
 public:
  explicit WheelPair(const WheelPairConfig& config) noexcept : config_(config), lag_(config.lag_s) {}
  void reset() noexcept;
  void command(double left_duty, double right_duty) noexcept;
  /// See Drive::supply(): speeds fall with the voltage.
  void supply(double share) noexcept { supply_ = share; }
  Movement move(const Pose2& pose, double step_s) noexcept;
  /// See Drive::foreseen().
  Movement foreseen(const Pose2& pose, double step_s) const noexcept { return WheelPair(*this).move(pose, step_s); }
  /// See Drive::steady_mps(): once the motors have followed their duties.
  double steady_mps() const noexcept;

 private:
  struct Side {
    double duty = 0;
    double speed_mps = 0;
  };
  double wanted_mps(const Side& side, double gain) const noexcept;
  /// The way of one rim within a step; its speed changes.
  double roll(Side& side, double gain, double step_s) noexcept;

  /// The unit vector of that yaw, remembered for those who drive straight.
  Vector2 towards(double yaw_rad) noexcept;

  WheelPairConfig config_;
  FirstOrderLag lag_;
  Side left_, right_;
  double supply_ = 1;
  double towards_rad_ = 0;
  Vector2 towards_{1, 0};
};

/// Parameters that several kinds list in their descriptors, of a Config with members of these names.
template <class Config>
consteval ParameterDescriptor full_scale_parameter() {
  return parameter<Config, &Config::full_scale_mps>(
      {.name = "full_scale_mps",
       .title = {"full speed", "velocidad máxima"},
       .help = {"Speed of a side at duty 1", "Velocidad de un lado con ciclo de trabajo 1"},
       .unit = "m/s",
       .min = 1e-6,
       .max = 50});
}
template <class Config>
consteval ParameterDescriptor track_parameter() {
  return parameter<Config, &Config::track_m>(
      {.name = "track_m",
       .title = {"track width", "ancho de vía"},
       .help = {"Distance between the wheels' contact lines", "Distancia entre las líneas de contacto de las ruedas"},
       .unit = "m",
       .min = 1e-3,
       .max = 100});
}
template <class Config>
consteval ParameterDescriptor dead_zone_parameter() {
  return parameter<Config, &Config::dead_zone>(
      {.name = "dead_zone",
       .title = {"dead zone", "zona muerta"},
       .help = {"Duties of less do not move a side", "Ciclos de trabajo menores no mueven un lado"},
       .min = 0,
       .max = 1,
       .ours = true});
}
template <class Config>
consteval ParameterDescriptor left_gain_parameter() {
  return parameter<Config, &Config::left_gain>(
      {.name = "left_gain",
       .title = {"left gain", "ganancia izquierda"},
       .help = {"Share of its speed that the left side reaches: unequal motors",
                "Parte de su velocidad que alcanza el lado izquierdo: motores desiguales"},
       .min = 0,
       .max = 2,
       .ours = true});
}
template <class Config>
consteval ParameterDescriptor right_gain_parameter() {
  return parameter<Config, &Config::right_gain>(
      {.name = "right_gain",
       .title = {"right gain", "ganancia derecha"},
       .help = {"Share of its speed that the right side reaches: unequal motors",
                "Parte de su velocidad que alcanza el lado derecho: motores desiguales"},
       .min = 0,
       .max = 2,
       .ours = true});
}
template <class Config>
consteval ParameterDescriptor motor_lag_parameter() {
  return parameter<Config, &Config::lag_s>(
      {.name = "lag_s",
       .title = {"motor lag", "retardo del motor"},
       .help = {"Time constant with which speeds follow duties",
                "Constante de tiempo con que las velocidades siguen a los ciclos de trabajo"},
       .unit = "s",
       .min = 0,
       .max = 60,
       .ours = true});
}
/// Element 0 is the left side's duty, 1 the right one's.
CommandElement wheel_pair_element(std::size_t n);

}  // namespace ganglion::sim
