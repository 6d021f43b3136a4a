#pragma once

#include <limits>

#include "ganglion/geometry/pose2.h"

namespace ganglion::sim {

/// What is true of a simulated robot, for measures and pictures. A controller only sees what sensors make of it.
struct Truth {
  Pose2 pose{};            ///< Of the body's centre, in the world.
  Pose2 start{};           ///< The pose of the last reset.
  Vector2 velocity_mps{};  ///< Over the last sub-step, in the world's frame; 0 while something blocks it.
  double turn_rate_radps = 0;
  /// Way of the left wheel's rim since the reset, backwards counting negative; a blocked robot slips.
  double left_m = 0;
  double right_m = 0;              ///< The same of the right wheel.
  double travelled_m = 0;          ///< Length of the centre's path since the reset.
  double energy_J = 0;             ///< Taken since the reset.
  double step_energy_J = 0;        ///< Taken by the last step.
  bool touching = false;           ///< Pressed against something, or at rest since it was.
  bool touched = false;            ///< Touching at any moment of the last step.
  Vector2 contact_normal{};        ///< Of the latest contact, away from what was touched.
  int contacts = 0;                ///< Contacts begun since the reset. Pushing on is no new contact.
  double contact_speed_mps = 0;    ///< Speed along the normal at which the last step's hardest contact began, else 0.
  double fastest_contact_mps = 0;  ///< The same since the reset.
  /// At its terminals, under load; NaN without a battery.
  double battery_V = std::numeric_limits<double>::quiet_NaN();
  double charge = 1;     ///< Share of the battery's capacity that is left.
  bool stalled = false;  ///< Kept in the last sub-step from climbing what is too steep for it.
  bool tipped = false;   ///< Has fallen over on a slope; moves no more.
};

}  // namespace ganglion::sim
