#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/descriptor/descriptor.h"
#include "ganglion/geometry/pose2.h"

namespace ganglion {

/// One sensation an application offers, e.g. "sonar_left.range": values that arrive with every frame.
struct SensationChannel {
  std::string name;  ///< "device.quantity"
  std::string unit;  ///< SI; "" = dimensionless
  ValueType type = ValueType::Real;
  std::vector<std::string> elements;  ///< Names of its values where there are several; empty = one value.
  double min = 0;                     ///< Finite readings lie within [min, max].
  double max = 0;
  double period_s = 0;                                     ///< Time between fresh readings; 0 = fresh in every frame.
  double dead = std::numeric_limits<double>::quiet_NaN();  ///< What it reads once the device is broken.
  /// What a full turn counts, of a value that begins anew after it: 3600 of a bearing in tenths of a degree. 0: Circular
  /// ones are angles in (-pi, pi], the others do not go round.
  double turn = 0;
  int size() const noexcept { return elements.empty() ? 1 : static_cast<int>(elements.size()); }
};

/// One value of a command, e.g. the left track of "drive".
struct CommandElement {
  std::string name;
  std::string unit;
  double min = -1;
  double max = 1;
  double safe = 0;  ///< Taken when nothing valid was commanded in time.
};

struct CommandChannel {
  std::string name;  ///< "drive"
  std::vector<CommandElement> elements;
};

/// A device on a body, for pictures.
struct Mount {
  std::string device;  ///< "sonar_left"; its channels are called that, or "sonar_left.range".
  std::string kind;    ///< "" = nobody knows.
  Pose2 pose{};
  double cone_rad = 0;     ///< Full width of what it hears or sees; 0 = a ray, or nobody knows.
  double max_range_m = 0;  ///< 0 = it measures no range.
};

/// Of what has a body in the plane: its outer size along x and y.
struct Body {
  double length_m = 0;
  double width_m = 0;
  double radius_m = 0;  ///< Of the disc that collides; 0 = nobody knows.
  std::vector<Mount> mounts;
};

/// What an application says of itself. Values of all sensations lie one after the other in frames, in this order; so do
/// the values of all commands.
struct Description {
  std::string name;
  double tick_s = 0.1;  ///< Time between frames the application prefers.
  std::vector<SensationChannel> sensations;
  std::vector<CommandChannel> commands;
  std::optional<Body> body;  ///< None: it has no place in the plane.

  int sensation_values() const noexcept;
  int command_values() const noexcept;
  /// Index of the first value of a channel in a frame.
  int sensation_offset(std::size_t channel) const noexcept;
  int command_offset(std::size_t channel) const noexcept;
  const SensationChannel* sensation(const std::string& channel_name) const noexcept;
  const CommandChannel* command(const std::string& channel_name) const noexcept;
  /// Where the device of a channel sits; null where nobody knows.
  const Mount* mount(std::string_view channel) const noexcept;
};

}  // namespace ganglion
