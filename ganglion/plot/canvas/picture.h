#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "ganglion/base/result.h"
#include "ganglion/plot/canvas/canvas.h"

namespace ganglion::plot {

/// A picture that can be drawn any number of times, in any format, by the same lines of code.
struct Picture {
  std::string id;           ///< Letters, digits, '-', '_': name of its files.
  std::string title;        ///< For the heading and for who cannot see it.
  std::string description;  ///< One or two sentences on what it shows.
  double width_px = 0;
  double height_px = 0;
  std::function<void(Canvas&)> draw;
};

enum class PictureFormat { Svg, Png, Pdf };

/// The file's content. Texts stay texts in SVG and PDF; SVG has <title> and <desc>; PNG has two dots per pixel. Fails
/// with TooLarge or Unreadable (Cairo).
Result<std::string> render(const Picture& picture, PictureFormat format);

/// One picture in two languages as SVG for a page whose style hides .said-en or .said-es: the shapes once and the texts
/// of both where the shapes are the same, else the whole picture twice. See inline_svg() for `id_prefix`.
Result<std::string> render_for_page(const Picture& english, const Picture& spanish, std::string_view id_prefix);

/// <folder>/<id>.svg and so on.
Result<std::filesystem::path> save(const Picture& picture, PictureFormat format, const std::filesystem::path& folder);

/// `text` with & < > " ' written as XML and HTML entities.
std::string escape_markup(std::string_view text);

/// Letters, digits, '-' and '_' of a name, the rest as '-': fit for a file or an id.
std::string file_stem(std::string_view name);

}  // namespace ganglion::plot
