#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace ganglion::report {

/// Numbers as little-endian bytes in base64: what unpack() of the player reads, on any machine.
std::string pack_f32(std::span<const double> values);
std::string pack_u32(std::span<const std::uint32_t> values);
std::string pack_u16(std::span<const std::uint16_t> values);
std::string pack_u8(std::span<const std::uint8_t> values);

}  // namespace ganglion::report
