#pragma once

#include <limits>

#include "tests/clients/c_robot.h"

// What controllers send to bench_robot.toml.
namespace ganglion::link {

inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
inline constexpr float kInf = std::numeric_limits<float>::infinity();
using Floats = std::vector<float>;
inline const Floats kSafe = {0, 0.25F, 0};  // as bench_robot.toml says

inline wire::Act act(std::uint32_t tick, const Floats& values, std::uint32_t ttl_ms = 0) {
  wire::Act message;
  message.set_tick(tick);
  message.set_ttl_ms(ttl_ms);
  for (const float value : values) message.add_values32(value);
  return message;
}

inline wire::Act step(std::uint32_t tick, double step_s, std::uint32_t ttl_ms = 60'000) {
  wire::Act message = act(tick, {0.5F, 0.5F, 0.5F}, ttl_ms);
  message.set_step_s(step_s);
  return message;
}

}  // namespace ganglion::link
