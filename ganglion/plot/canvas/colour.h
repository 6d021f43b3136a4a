#pragma once

#include <array>
#include <cstdint>

namespace ganglion::plot {

/// sRGB, each part in [0, 1].
struct Colour {
  double red = 0;
  double green = 0;
  double blue = 0;
  double alpha = 1;

  static constexpr Colour hex(std::uint32_t rgb) noexcept {
    return {((rgb >> 16) & 0xff) / 255.0, ((rgb >> 8) & 0xff) / 255.0, (rgb & 0xff) / 255.0, 1};
  }
  constexpr Colour faded(double opacity) const noexcept { return {red, green, blue, opacity}; }
  /// Brightness as seen by the eye, 0 black to 1 white (Rec. 709 weights on the coded values).
  constexpr double brightness() const noexcept { return 0.2126 * red + 0.7152 * green + 0.0722 * blue; }
};

/// The colour of a value in [0, 1] on the viridis scale (van der Walt and Smith, 2015): even steps to the eye, in grey
/// and for the colour-blind too. Values outside are clamped; NaN takes the lower end.
Colour viridis(double value) noexcept;

/// How one of several behaviours, robots or lines is drawn; tells them apart without colour by dash and marker.
struct LineLook {
  Colour colour;
  std::array<double, 4> dash_px;  ///< Lengths on, off, on, off; all 0 = an unbroken line.
  int marker;                     ///< 0..7: disc, triangle, square, diamond, cross, plus, ring, star
};

/// Eight looks, told apart in grey and by every kind of colour vision (after Okabe and Ito); repeats after them.
LineLook look(int index) noexcept;

}  // namespace ganglion::plot
