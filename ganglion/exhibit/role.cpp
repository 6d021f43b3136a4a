#include "ganglion/exhibit/role.h"

namespace ganglion {
namespace {

constexpr std::array<RoleLook, 19> kLooks = {{
    {.role = Role::Plain, .name = "plain", .word = {"mark", "marca"}, .light = 0x4b535d, .dark = 0xaab3bd},
    {.role = Role::Solid,
     .name = "solid",
     .word = {"solid", "sólido"},
     .light = 0x343c46,
     .dark = 0xc8d0d8,
     .sign = Sign::Hatch,
     .filled = true},
    {.role = Role::Free,
     .name = "free",
     .word = {"free", "libre"},
     .light = 0x96c8be,
     .dark = 0x3f776b,
     .filled = true},
    {.role = Role::Unknown,
     .name = "unknown",
     .word = {"unknown", "desconocido"},
     .light = 0x9aa2ab,
     .dark = 0x75808c,
     .dash = {3, 3}},
    {.role = Role::Moving,
     .name = "moving",
     .word = {"moving", "móvil"},
     .light = 0x9aa2ab,
     .dark = 0x75808c,
     .sign = Sign::Dot,
     .filled = true},
    {.role = Role::Plan,
     .name = "plan",
     .word = {"plan", "plan previsto"},
     .light = 0x7a2bb5,
     .dark = 0xcda1ea,
     .dash = {7, 4}},
    {.role = Role::Tried,
     .name = "tried",
     .word = {"failed attempt", "intento fallido"},
     .light = 0xa87f00,
     .dark = 0xe6bb2e,
     .dash = {1.5, 3},
     .lasts = true},
    {.role = Role::Goal,
     .name = "goal",
     .word = {"goal", "objetivo"},
     .light = 0xffd21f,
     .dark = 0xffd21f,
     .filled = true,
     .lasts = true},
    {.role = Role::Reached,
     .name = "reached",
     .word = {"goal reached", "objetivo alcanzado"},
     .light = 0xb7d34c,
     .dark = 0xb7d34c,
     .filled = true,
     .over = true,
     .lasts = true},
    {.role = Role::GivenUp,
     .name = "given_up",
     .word = {"goal given up", "objetivo abandonado"},
     .light = 0xffd21f,
     .dark = 0xffd21f,
     .sign = Sign::Cross,
     .filled = true,
     .over = true,
     .lasts = true},
    {.role = Role::Past,
     .name = "past",
     .word = {"no longer counts", "ya no cuenta"},
     .light = 0xe8d58a,
     .dark = 0x8a7a35,
     .filled = true,
     .over = true,
     .lasts = true},
    {.role = Role::Self,
     .name = "self",
     .word = {"itself", "sí mismo"},
     .light = 0xd98a2b,
     .dark = 0xffb765,
     .filled = true},
    {.role = Role::Other,
     .name = "other",
     .word = {"another", "otro"},
     .light = 0x6d7783,
     .dark = 0x9aa4af,
     .filled = true},
    {.role = Role::Sensing, .name = "sensing", .word = {"sensor", "sensor"}, .light = 0x1f5fd0, .dark = 0x6ea4ff},
    {.role = Role::Echo, .name = "echo", .word = {"echo", "eco"}, .light = 0x1f5fd0, .dark = 0x6ea4ff, .dash = {2, 2}},
    {.role = Role::Danger,
     .name = "danger",
     .word = {"danger", "peligro"},
     .light = 0xb3123a,
     .dark = 0xff6b81,
     .sign = Sign::Cross},
    {.role = Role::Place,
     .name = "place",
     .word = {"place", "lugar"},
     .light = 0x118568,
     .dark = 0x38ebbc,
     .filled = true,
     .lasts = true},
    {.role = Role::Reference,
     .name = "reference",
     .word = {"reference", "referencia"},
     .light = 0x5b6470,
     .dark = 0x9aa4af,
     .dash = {9, 3}},
    {.role = Role::Measured, .name = "measured", .word = {"measured", "medido"}, .light = 0x1c437e, .dark = 0x8fb3ff},
}};

consteval bool in_order() {
  for (std::size_t i = 0; i < kLooks.size(); ++i) {
    if (static_cast<std::size_t>(kLooks[i].role) != i) return false;
  }
  return true;
}
static_assert(in_order(), "the table has every role at its own place");

}  // namespace

std::string_view name_of(Sign sign) noexcept {
  switch (sign) {
    case Sign::None:
      return "none";
    case Sign::Hatch:
      return "hatch";
    case Sign::Dot:
      return "dot";
    case Sign::Cross:
      break;
  }
  return "cross";
}

std::span<const RoleLook> role_looks() noexcept { return kLooks; }

const RoleLook& look_of(Role role) noexcept {
  const auto index = static_cast<std::size_t>(role);
  return index < kLooks.size() ? kLooks[index] : kLooks[0];
}

std::optional<Role> role_named(std::string_view name) noexcept {
  for (const RoleLook& look : kLooks) {
    if (look.name == name) return look.role;
  }
  return std::nullopt;
}

}  // namespace ganglion
