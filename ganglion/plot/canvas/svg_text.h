#pragma once

#include <span>
#include <string>
#include <string_view>

#include "ganglion/plot/canvas/canvas.h"

namespace ganglion::plot {

/// Makes Cairo's SVG fit for a page: a title and description, texts as <text> of the very width they were laid out
/// with (so another font moves nothing), ids that begin with `id_prefix`, numbers rounded to hundredths of a pixel.
std::string finish_svg(std::string_view cairo_svg, std::span<const PlacedText> texts, std::string_view title,
                       std::string_view description, std::string_view id_prefix);

}  // namespace ganglion::plot
