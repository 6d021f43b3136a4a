#include "ganglion/plot/canvas/picture.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "ganglion/base/file.h"
#include "ganglion/plot/canvas/svg_text.h"

namespace ganglion::plot {
namespace {

constexpr double kMaxSide_px = 16000;  // Cairo's images end at 32767 dots
constexpr double kDotsPerPixel = 2;
constexpr double kPointsPerPixel = 0.75;

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

cairo_status_t append(void* sink, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(sink)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

Surface make_surface(const Picture& picture, PictureFormat format, std::string& sink) {
  const double width = std::ceil(picture.width_px);
  const double height = std::ceil(picture.height_px);
  switch (format) {
    case PictureFormat::Svg: {
      Surface surface(cairo_svg_surface_create_for_stream(append, &sink, width, height), cairo_surface_destroy);
      cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
      return surface;
    }
    case PictureFormat::Pdf: {
      Surface surface(
          cairo_pdf_surface_create_for_stream(append, &sink, width * kPointsPerPixel, height * kPointsPerPixel),
          cairo_surface_destroy);
      cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, clean_text(picture.title).c_str());
      return surface;
    }
    case PictureFormat::Png:
      break;
  }
  return {cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width * kDotsPerPixel),
                                     static_cast<int>(height * kDotsPerPixel)),
          cairo_surface_destroy};
}

double scale_of(PictureFormat format) noexcept {
  return format == PictureFormat::Png ? kDotsPerPixel : format == PictureFormat::Pdf ? kPointsPerPixel : 1;
}

/// Draws the whole picture; the status says whether Cairo held out.
cairo_status_t draw(const Picture& picture, PictureFormat format, cairo_surface_t* surface,
                    std::vector<PlacedText>& texts) {
  const Context context(cairo_create(surface), cairo_destroy);
  cairo_scale(context.get(), scale_of(format), scale_of(format));
  Canvas canvas(context.get(), format == PictureFormat::Svg ? &texts : nullptr);
  canvas.rectangle({0, 0}, {std::ceil(picture.width_px), std::ceil(picture.height_px)}, Colour::hex(0xffffff));
  picture.draw(canvas);
  cairo_show_page(context.get());
  return cairo_status(context.get());
}

/// What Cairo wrote, and the texts it was not given.
struct Rendered {
  std::string bytes;
  std::vector<PlacedText> texts;
};

Result<Rendered> render_parts(const Picture& picture, PictureFormat format) {
  if (!(picture.width_px >= 1 && picture.width_px <= kMaxSide_px && picture.height_px >= 1 &&
        picture.height_px <= kMaxSide_px))
    return fail(ErrorCode::TooLarge,
                {"picture {}: {} x {} pixels, at most {} each way",
                 "imagen {}: {} x {} píxeles, como máximo {} en cada sentido"},
                picture.id, picture.width_px, picture.height_px, kMaxSide_px);
  Rendered rendered;
  const Surface surface = make_surface(picture, format, rendered.bytes);
  cairo_status_t status = draw(picture, format, surface.get(), rendered.texts);
  if (status == CAIRO_STATUS_SUCCESS && format == PictureFormat::Png)
    status = cairo_surface_write_to_png_stream(surface.get(), append, &rendered.bytes);
  cairo_surface_finish(surface.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS)
    return fail(ErrorCode::Unreadable, {"picture {}: {}", "imagen {}: {}"}, picture.id, cairo_status_to_string(status));
  return rendered;
}

}  // namespace

Result<std::string> render(const Picture& picture, PictureFormat format) {
  auto rendered = render_parts(picture, format);
  if (!rendered) return tl::unexpected(rendered.error());
  if (format != PictureFormat::Svg) return std::move(rendered->bytes);
  return finish_svg(rendered->bytes, rendered->texts, picture.title, picture.description);
}

Result<std::string> render_for_page(const Picture& english, const Picture& spanish, std::string_view id_prefix) {
  const auto en = render_parts(english, PictureFormat::Svg);
  if (!en) return tl::unexpected(en.error());
  const auto es = render_parts(spanish, PictureFormat::Svg);
  if (!es) return tl::unexpected(es.error());
  const SaidTexts said[] = {{"en", en->texts}, {"es", es->texts}};
  if (same_shapes(en->bytes, es->bytes)) return inline_svg(en->bytes, said, id_prefix);
  return fmt::format("<div class=\"said-en\">{}</div><div class=\"said-es\">{}</div>",
                     inline_svg(en->bytes, std::span(said, 1), fmt::format("{}en-", id_prefix)),
                     inline_svg(es->bytes, std::span(said + 1, 1), fmt::format("{}es-", id_prefix)));
}

Result<std::filesystem::path> save(const Picture& picture, PictureFormat format, const std::filesystem::path& folder) {
  static constexpr std::array<const char*, 3> kExtensions{".svg", ".png", ".pdf"};
  const auto content = render(picture, format);
  if (!content) return tl::unexpected(content.error());
  const std::filesystem::path path = folder / (file_stem(picture.id) + kExtensions[static_cast<std::size_t>(format)]);
  if (const auto written = write_file(path, *content); !written) return tl::unexpected(written.error());
  return path;
}

std::string escape_markup(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string file_stem(std::string_view name) {
  std::string result;
  for (const char c : name.substr(0, 80)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    result += plain ? c : '-';
  }
  return result.empty() ? "picture" : result;
}

}  // namespace ganglion::plot
