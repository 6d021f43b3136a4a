#pragma once

#include "ganglion/sim/robot/sensor.h"

namespace ganglion::sim {

/// Which part of the light a camera takes; in the order of the words in files.
enum class Filter : std::uint8_t { Grey, Red, Green, Blue };

struct PixelMatrixConfig {
  Angle width = Angle::from_deg(64);   ///< Field of view, 8 columns.
  Angle height = Angle::from_deg(64);  ///< 8 rows.
  Angle down = Angle::from_deg(20);    ///< How far the middle of the picture lies below the horizon.
  double height_m = 0.2;               ///< Of the lens above the floor.
  double reach_m = 10;                 ///< Farther off there is only background.
  double wall_height_m = 2;
  Filter filter = Filter::Grey;
  double noise = 0.02;  ///< Standard deviation of one pixel.
  int levels = 64;      ///< Pixels take that many values; 0 = not rounded.
};

/// A coarse camera of 8 x 8 pixels. Channel `pixels`: brightness in [0, 1], 0 black, row by row from the top, from left
/// to right. Every pixel looks along its middle. What it meets first shows:
///   floor      the colour of its zone, or plain floor;
///   a wall, a solid, a mover, another robot (as high as a wall)   by its material, rough 0.5, smooth 0.8, soft 0.3,
///              darkened by a factor of (1 + cos of the incidence) / 2;
///   background 0, above walls and beyond the reach.
/// A beacon of light within its range and with no wall before it shows in the pixel it lies in, over all else. Grey is
/// 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709). All but that is ours.
class PixelMatrix final : public Sensor {
 public:
  static constexpr int kSide = 8;

  explicit PixelMatrix(const PixelMatrixConfig& config) noexcept;
  bool remembers() const noexcept override { return false; }
  Limits limits(std::size_t) const noexcept override { return {0, 1}; }
  double reach_m() const noexcept override { return config_.reach_m; }
  void measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept override;

 private:
  double brightness(const Colour& colour) const noexcept;
  void paint_column(const Scene& scene, int column, std::span<double> pixels) const noexcept;
  void paint_beacon(const Scene& scene, const Beacon& beacon, std::span<double> pixels) const noexcept;

  PixelMatrixConfig config_;
  std::array<Vector2, kSide> columns_{};  // unit directions in the sensor's frame, from the left
  std::array<double, kSide> fall_{};      // metres down for each metre along the ground, rows from the top
};

extern const SensorKind pixel_matrix_kind;

}  // namespace ganglion::sim
