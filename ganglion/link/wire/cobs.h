#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ganglion::link {

/// CRC-16/IBM-3740, also known as CCITT-FALSE: polynomial 0x1021, from 0xFFFF, nothing reflected, no final XOR.
/// "123456789" gives 0x29B1. Source: Greg Cook, "Catalogue of parametrised CRC algorithms".
std::uint16_t crc16(std::string_view bytes) noexcept;

/// Appends a packet for a serial line: payload and its CRC (high byte first) in consistent overhead byte stuffing, then
/// a zero byte, which stands nowhere else. Source: Cheshire and Baker, "Consistent Overhead Byte Stuffing" (1999).
void append_packet(std::string_view payload, std::string& out);

/// Takes a packet without its zero byte apart, in place. Gives the payload, a view into `packet`; none where it is
/// damaged.
bool open_packet(std::string& packet, std::string_view& payload) noexcept;

}  // namespace ganglion::link
