#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/application/description.h"
#include "ganglion/config/table.h"
#include "ganglion/sim/robot/drive.h"
#include "ganglion/sim/robot/sensor.h"
#include "ganglion/task/task_model.h"

namespace ganglion::sim {

/// The kinds a robot file may name; the program passes the generated lists.
struct SimKinds {
  std::span<const DriveKind* const> drives;
  std::span<const SensorKind* const> sensors;
  std::span<const TaskKind* const> tasks{};
};

/// What a device does to a fault: for tests of graceful degradation.
enum class Fault : std::uint8_t {
  None,
  Dead,   ///< No valid reading any more: NaN, or what the kind gives.
  Stuck,  ///< Repeats its last reading as if it were fresh.
};

/// The keys that every [[sensor]] has besides its kind's parameters.
struct SensorCommon {
  double x_m = 0;  ///< Where it sits on the body.
  double y_m = 0;
  Angle yaw;
  double period_s = 0;
  double phase_s = 0;
  Fault fault = Fault::None;
  double fault_from_s = 0;
};

/// One sensor as the file has it, common keys apart from those of its kind.
struct SensorModel {
  std::string id;
  const SensorKind* kind = nullptr;
  Parameters parameters{{}};
  Pose2 mount{};        ///< On the body.
  double period_s = 0;  ///< 0 = fires for every frame.
  double phase_s = 0;   ///< Time of its first firing: sensors that must not hear each other fire in turn.
  Fault fault = Fault::None;
  double fault_from_s = 0;
};

/// The energy a step takes: idle_W t + drive_W effort t + travel_J_per_m way + contact_J for each contact begun.
struct EnergyModel {
  double idle_W = 0;
  double drive_W = 1;
  double travel_J_per_m = 0;
  double contact_J = 0;
};

/// What the robot's energy is taken from. The open voltage falls in a straight line with the charge; the resistance
/// takes its part with the current. Drives slow down with the voltage and stand once the charge is gone. Ours.
struct BatteryModel {
  double capacity_J = 50000;  ///< 0 = no battery: energy without end at full voltage.
  double full_V = 8.4;        ///< Open, at full charge; what the drive's full speed is stated for.
  double empty_V = 6;         ///< Open, at the end of the charge.
  double resistance_ohm = 0.1;
  double charge = 1;  ///< At the start of an episode.

  bool present() const noexcept { return capacity_J > 0; }
  /// At the terminals: the root of V^2 - open V + R P = 0, V = open / 2 + sqrt(open^2 / 4 - R P); half the open voltage
  /// where that power is more than the battery can give, 0 without charge.
  double voltage_V(double charge_left, double power_W) const noexcept;
};

/// A robot as its file states it: immutable, shared by any number of simulations and threads.
struct RobotModel {
  Description description;  ///< Of the robot alone.
  Description tasked;       ///< With the channels of its tasks behind.
  double radius_m = 0;      ///< In contact and in sight of others the body is a disc about its centre.
  double substep_s = 0.01;  ///< Motion and contacts are worked out in steps of at most this.
  EnergyModel energy{};
  BatteryModel battery{.capacity_J = 0};  ///< None without [battery].
  double climb_rad = kPi / 2;             ///< Steepest slope its drive can climb; on steeper ones it stalls.
  double tip_rad = kPi / 2;               ///< On slopes steeper than that it tips over.
  const DriveKind* drive = nullptr;       ///< Null: the file only describes a robot that is not simulated.
  Parameters drive_parameters{{}};
  std::vector<SensorModel> sensors;
  std::vector<TaskModel> tasks;  ///< Set to every robot of the model.

  bool simulated() const noexcept { return drive != nullptr; }
};

/// Reads a robot.toml. Null if there were problems; all of them are in `problems`, each with its place.
///
/// A file has `format = 1`, `name`, `tick_s`, and `[body] length_m, width_m, radius_m`: the disc that collides has half
/// the body's diagonal as its radius unless `radius_m` is given. Then either
///   * a simulated robot: `[drive] kind` and its parameters, any number of `[[sensor]] id, kind, x_m, y_m, yaw_deg,
///     period_s, phase_s, fault, fault_from_s` and its parameters, `[energy]` (EnergyModel), `[battery]`
///     (BatteryModel), any number of `[[task]] id, kind` and its parameters, `substep_s`, and on the body `climb_deg`,
///     `tip_deg`; sensations are then named "id.channel", and the command channel as the drive's kind names it; or
///   * a bare description of a robot elsewhere: `[[sensation]] name, unit, type, elements, min, max, period_s, x_m,
///     y_m, yaw_deg` and `[[command]] name, elements, units, min, max, safe`.
std::shared_ptr<const RobotModel> read_robot(const config::Value& value, const SimKinds& kinds, Problems& problems,
                                             FileReader* files = nullptr, config::Outline* outline = nullptr);
/// The same from a text. `outline` takes down what was asked.
std::shared_ptr<const RobotModel> parse_robot(std::string_view text, const std::string& file_name,
                                              const SimKinds& kinds, Problems& problems,
                                              config::Outline* outline = nullptr);
/// Those of SensorCommon, as descriptors for schema, forms and manual.
std::span<const ParameterDescriptor> sensor_parameters() noexcept;
/// The keys of [energy].
std::span<const ParameterDescriptor> energy_parameters() noexcept;
/// The keys of [battery].
std::span<const ParameterDescriptor> battery_parameters() noexcept;

}  // namespace ganglion::sim
