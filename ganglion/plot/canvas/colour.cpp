#include "ganglion/plot/canvas/colour.h"

#include <algorithm>

namespace ganglion::plot {

Colour viridis(double value) noexcept {
  static constexpr std::array<std::uint32_t, 11> kStops{0x440154, 0x482576, 0x414487, 0x35608d, 0x2a788e, 0x21908c,
                                                        0x22a884, 0x43bf71, 0x7ad151, 0xbbdf27, 0xfde725};
  const double place = (value > 0 ? std::min(value, 1.0) : 0.0) * (kStops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
  const double part = place - static_cast<double>(below);
  const Colour a = Colour::hex(kStops[below]);
  const Colour b = Colour::hex(kStops[below + 1]);
  return {a.red + part * (b.red - a.red), a.green + part * (b.green - a.green), a.blue + part * (b.blue - a.blue), 1};
}

LineLook look(int index) noexcept {
  static constexpr std::array<LineLook, 8> kLooks{{
      {Colour::hex(0x0072b2), {0, 0, 0, 0}, 0},
      {Colour::hex(0xd55e00), {7, 3, 7, 3}, 1},
      {Colour::hex(0x007a5a), {2, 2.5, 2, 2.5}, 2},
      {Colour::hex(0xb0478f), {9, 3, 2, 3}, 3},
      {Colour::hex(0x2b2b2b), {4, 2, 4, 2}, 4},
      {Colour::hex(0x9a6b00), {12, 4, 12, 4}, 5},
      {Colour::hex(0x3a97d4), {2, 5, 2, 5}, 6},
      {Colour::hex(0x6b4fbb), {9, 2, 4, 2}, 7},
  }};
  return kLooks[static_cast<std::size_t>(index % 8 + 8) % 8];
}

}  // namespace ganglion::plot
