#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ganglion/plot/canvas/canvas.h"

namespace ganglion::plot {

/// Explains the signs of a picture: a sample beside a word, one below the other.
class Legend {
 public:
  /// Draws a sample about 30 x 14 pixels around `centre`.
  using Sample = std::function<void(Canvas&, Vector2 centre)>;
  void add(std::string label, Sample sample) { rows_.push_back({std::move(label), std::move(sample)}); }
  void add_line(std::string label, const Pen& pen, int marker = -1);

  bool empty() const noexcept { return rows_.empty(); }
  double height_px() const noexcept;
  /// Labels are shortened to fit `width_px`.
  void draw(Canvas& canvas, Vector2 corner, double width_px, std::string_view title) const;

 private:
  struct Row {
    std::string label;
    Sample sample;
  };
  std::vector<Row> rows_;
};

}  // namespace ganglion::plot
