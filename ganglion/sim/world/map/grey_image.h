#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"

namespace ganglion::sim {

/// A grey picture, top row first.
struct GreyImage {
  int columns = 0;
  int rows = 0;
  int max_value = 255;                ///< White; 1..65535.
  std::vector<std::uint16_t> values;  ///< 0..max_value.
};

/// Reads PGM, binary (P5) or plain (P2), with comments. Fails with Syntax, Corrupt where pixels are missing or brighter
/// than white, Unsupported for other formats, TooLarge beyond max_pixels. Source: netpbm.sourceforge.net/doc/pgm.html.
Result<GreyImage> parse_pgm(std::string_view bytes, const std::string& file_name, std::size_t max_pixels);

}  // namespace ganglion::sim
