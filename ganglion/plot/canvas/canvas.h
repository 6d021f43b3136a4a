#pragma once

#include <cairo.h>

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/geometry/vector2.h"
#include "ganglion/plot/canvas/colour.h"

namespace ganglion::plot {

/// How a line is drawn; lengths in pixels of the picture.
struct Pen {
  Colour colour{};
  double width_px = 1;
  std::array<double, 4> dash_px{};
};

/// Which point of a text its place names: along the line of writing.
enum class Anchor { Start, Middle, End };

struct TextStyle {
  Colour colour = Colour::hex(0x1c2127);
  double size_px = 12;
  bool bold = false;
  bool upright = false;  ///< Written from below upwards.
};

/// A text that an SVG file carries as text, so that it can be searched, read aloud and selected.
struct PlacedText {
  std::string text;
  Vector2 place;
  double width_px;
  Anchor anchor;
  TextStyle style;
};

/// Coloured cells, for grids too large to be drawn as shapes; transparent at first. Row 0 is the lowest.
class CellImage {
 public:
  CellImage(int columns, int rows);
  /// What lies outside is left out.
  void fill(int column, int row, int columns, int rows, Colour colour);
  int columns() const noexcept { return columns_; }
  int rows() const noexcept { return rows_; }
  std::span<const std::uint32_t> dots() const noexcept { return dots_; }

 private:
  int columns_;
  int rows_;
  std::vector<std::uint32_t> dots_;  ///< As Cairo's ARGB32, the highest row first.
};

/// What pictures are drawn with: Cairo in pixels, x to the right, y down. Texts are cleaned of what is no valid UTF-8.
/// Lengths are in pixels; a point that is not finite is left out.
class Canvas {
 public:
  /// Draws into `context`, which is kept alive by the caller. With `gathered` the texts go there instead.
  Canvas(cairo_t* context, std::vector<PlacedText>* gathered) noexcept : context_(context), gathered_(gathered) {}

  void line(std::span<const Vector2> points, const Pen& pen);
  void line(Vector2 from, Vector2 to, const Pen& pen);
  void polygon(std::span<const Vector2> points, Colour fill);
  void polygon(std::span<const Vector2> points, Colour fill, const Pen& edge);
  /// Many shapes of one colour as one path, which keeps files small.
  void polygons(std::span<const std::vector<Vector2>> shapes, Colour fill);
  void rectangles(std::span<const std::array<Vector2, 2>> corners_and_sizes, Colour fill);
  void rectangle(Vector2 corner, Vector2 size, Colour fill);
  void rectangle(Vector2 corner, Vector2 size, const Pen& edge);
  void disc(Vector2 centre, double radius_px, Colour fill);
  void disc(Vector2 centre, double radius_px, Colour fill, const Pen& edge);
  /// One of the eight markers of look(), about `size_px` across.
  void marker(int kind, Vector2 centre, double size_px, Colour colour);
  /// An arrow head at `tip` pointing along `heading` (any length).
  void arrow_head(Vector2 tip, Vector2 heading, double size_px, Colour colour);
  /// Diagonal lines `gap_px` apart inside the rectangles (each corner, size).
  void hatch(std::span<const std::array<Vector2, 2>> rectangles, double gap_px, const Pen& pen);

  void text(Vector2 place, std::string_view words, Anchor anchor = Anchor::Start, const TextStyle& style = {});
  double text_width(std::string_view words, const TextStyle& style = {});
  /// The text, shortened with an ellipsis where it is wider than `width_px`.
  std::string fitted(std::string_view words, double width_px, const TextStyle& style = {});

  /// Cells in the parallelogram from the lower left `corner` along `right` and `up`.
  void image(const CellImage& cells, Vector2 corner, Vector2 right, Vector2 up);

  /// Nothing outside the rectangle is drawn until unclip(); texts are not clipped.
  void clip(Vector2 corner, Vector2 size);
  void unclip();

 private:
  void trace(std::span<const Vector2> points, bool closed);
  void stroke(const Pen& pen);
  void fill(Colour colour, bool keep = false);
  void use_font(const TextStyle& style);

  cairo_t* context_;
  std::vector<PlacedText>* gathered_;
};

/// Valid UTF-8 without control characters, at most 400 bytes: what pictures and XML can hold.
std::string clean_text(std::string_view words);

}  // namespace ganglion::plot
