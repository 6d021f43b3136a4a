#pragma once

namespace ganglion {

/// Speed of sound in dry air [m/s] at a temperature in deg C: 331.3 + 0.606 T, within 0.25 % of the root from -20
/// to 40.
constexpr double speed_of_sound_mps(double air_C) noexcept { return 331.3 + 0.606 * air_C; }

}  // namespace ganglion
