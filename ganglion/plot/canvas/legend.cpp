#include "ganglion/plot/canvas/legend.h"

namespace ganglion::plot {
namespace {

constexpr double kRow_px = 21;
constexpr double kTitle_px = 24;
constexpr double kSample_px = 40;

}  // namespace

void Legend::add_line(std::string label, const Pen& pen, int marker) {
  add(std::move(label), [pen, marker](Canvas& canvas, Vector2 centre) {
    canvas.line(centre - Vector2{16, 0}, centre + Vector2{16, 0}, pen);
    if (marker >= 0) canvas.marker(marker, centre, 8, pen.colour);
  });
}

double Legend::height_px() const noexcept { return kTitle_px + kRow_px * static_cast<double>(rows_.size()); }

void Legend::draw(Canvas& canvas, Vector2 corner, double width_px, std::string_view title) const {
  canvas.text(corner + Vector2{0, 12}, title, Anchor::Start, {.size_px = 12, .bold = true});
  double y = corner.y + kTitle_px;
  for (const Row& row : rows_) {
    row.sample(canvas, {corner.x + 16, y + kRow_px / 2});
    canvas.text({corner.x + kSample_px, y + kRow_px / 2 + 4}, canvas.fitted(row.label, width_px - kSample_px));
    y += kRow_px;
  }
}

}  // namespace ganglion::plot
