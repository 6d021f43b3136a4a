#pragma once

#include <span>
#include <string>
#include <string_view>

#include "ganglion/plot/canvas/canvas.h"

namespace ganglion::plot {

/// Makes Cairo's SVG fit for a file: a title and description, texts as <text> of the very width they were laid out
/// with (so another font moves nothing), numbers rounded to hundredths of a pixel.
std::string finish_svg(std::string_view cairo_svg, std::span<const PlacedText> texts, std::string_view title,
                       std::string_view description);

/// Whether two of Cairo's files draw the same, whatever their ids.
bool same_shapes(std::string_view cairo_svg, std::string_view other);

/// The words of a picture in one language, for an element of class "said-<tag>".
struct SaidTexts {
  std::string_view tag;
  std::span<const PlacedText> texts;
};

/// The same as an element for an HTML page: no XML header, named by the element with id "<id_prefix>caption", ids that
/// begin with `id_prefix` so that many can stand in one page, and the texts of every language given.
std::string inline_svg(std::string_view cairo_svg, std::span<const SaidTexts> said, std::string_view id_prefix);

}  // namespace ganglion::plot
