#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ganglion {

/// RFC 4648, section 4, with padding.
std::string base64(std::span<const std::uint8_t> bytes);

/// The bytes of such a text, padded or not; none if it is not one.
std::optional<std::vector<std::uint8_t>> base64_bytes(std::string_view text);

}  // namespace ganglion
