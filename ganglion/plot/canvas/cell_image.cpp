#include <algorithm>
#include <cstring>

#include "ganglion/plot/canvas/canvas.h"

namespace ganglion::plot {

CellImage::CellImage(int columns, int rows)
    : columns_(std::max(columns, 0)),
      rows_(std::max(rows, 0)),
      dots_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {}

void CellImage::fill(int column, int row, int columns, int rows, Colour colour) {
  const auto part = [](double value) { return static_cast<std::uint32_t>(value * 255 + 0.5); };
  const std::uint32_t dot = 0xff000000u | part(colour.red) << 16 | part(colour.green) << 8 | part(colour.blue);
  const int right = static_cast<int>(std::min<long>(columns_, static_cast<long>(column) + columns));
  const int top = static_cast<int>(std::min<long>(rows_, static_cast<long>(row) + rows));
  for (int r = std::max(row, 0); r < top; ++r)
    for (int c = std::max(column, 0); c < right; ++c)
      dots_[static_cast<std::size_t>(rows_ - 1 - r) * static_cast<std::size_t>(columns_) +
            static_cast<std::size_t>(c)] = dot;
}

void Canvas::image(const CellImage& cells, Vector2 corner, Vector2 right, Vector2 up) {
  if (cells.columns() == 0 || cells.rows() == 0) return;
  cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, cells.columns(), cells.rows());
  if (cairo_surface_status(surface) == CAIRO_STATUS_SUCCESS) {
    unsigned char* data = cairo_image_surface_get_data(surface);
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
    const std::size_t bytes = static_cast<std::size_t>(cells.columns()) * sizeof(std::uint32_t);
    for (int row = 0; row < cells.rows(); ++row)
      std::memcpy(data + static_cast<std::size_t>(row) * stride,
                  cells.dots().data() + static_cast<std::size_t>(row) * cells.columns(), bytes);
    cairo_surface_mark_dirty(surface);
    cairo_save(context_);
    const Vector2 across = right * (1.0 / cells.columns());
    const Vector2 down = up * (-1.0 / cells.rows());
    const cairo_matrix_t matrix{across.x, across.y, down.x, down.y, corner.x + up.x, corner.y + up.y};
    cairo_transform(context_, &matrix);
    cairo_set_source_surface(context_, surface, 0, 0);
    cairo_pattern_set_filter(cairo_get_source(context_), CAIRO_FILTER_NEAREST);
    cairo_paint(context_);
    cairo_restore(context_);
  }
  cairo_surface_destroy(surface);
}

}  // namespace ganglion::plot
