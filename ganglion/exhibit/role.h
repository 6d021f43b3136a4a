#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "ganglion/base/sentence.h"

namespace ganglion {

/// What a thing is to the eye. Every face of Ganglion draws a role alike: pictures, player and studio.
enum class Role : std::uint8_t {
  Plain,
  Solid,
  Free,
  Unknown,
  Moving,
  Plan,
  Tried,
  Goal,
  Reached,
  GivenUp,
  Past,
  Self,
  Other,
  Sensing,
  Echo,
  Danger,
  Place,
  Reference,
  Measured
};

/// What marks a cell of a class besides its colour.
enum class Sign : std::uint8_t { None, Hatch, Dot, Cross };
std::string_view name_of(Sign sign) noexcept;

/// How a role is drawn, and what a legend calls it.
struct RoleLook {
  Role role;
  std::string_view name;         ///< As recorded: "given_up".
  Text word;                     ///< "given up"
  std::uint32_t light, dark;     ///< sRGB on light and on dark ground.
  std::array<double, 2> dash{};  ///< Pixels on and off; {0, 0} = an unbroken line.
  Sign sign = Sign::None;
  bool filled = false;  ///< Closed shapes are filled, not only outlined.
  bool over = false;    ///< Counts no more at the time that is looked at: drawn faintly there.
  bool lasts = false;   ///< A picture of a whole run shows it though it went during the run.
};

/// All roles, in the order of the enumeration.
std::span<const RoleLook> role_looks() noexcept;
const RoleLook& look_of(Role role) noexcept;
/// None where no role has that name.
std::optional<Role> role_named(std::string_view name) noexcept;

}  // namespace ganglion
