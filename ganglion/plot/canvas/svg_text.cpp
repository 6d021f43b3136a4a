#include "ganglion/plot/canvas/svg_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "ganglion/base/text.h"
#include "ganglion/plot/canvas/picture.h"

namespace ganglion::plot {
namespace {

bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

/// Hundredths are enough for the eye; transformation matrices keep more, they multiply.
std::string rounded(std::string_view number) {
  const std::size_t point = number.find('.');
  const bool matrix_factor = point == 1 && number[0] == '0';
  const std::size_t decimals = matrix_factor ? 4 : 2;
  if (point == std::string_view::npos || number.size() <= point + 1 + decimals) return std::string(number);
  const auto value = parse_number(number);
  if (!value) return std::string(number);
  std::string text = fmt::format("{:.{}f}", *value, decimals);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

/// Cairo counts its ids through the whole process; here they are i1, i2... in the order they come, so that equal
/// pictures have equal files.
class Ids {
 public:
  explicit Ids(std::string_view prefix) : prefix_(prefix) {}
  std::string renamed(std::string_view id) {
    const auto known = numbers_.emplace(id, numbers_.size() + 1).first;
    return fmt::format("{}i{}", prefix_, known->second);
  }

 private:
  std::string_view prefix_;
  std::map<std::string, std::size_t, std::less<>> numbers_;
};

/// Whether a number of the markup may begin after this letter.
bool before_number(char c) noexcept { return std::string_view(" -\"(,").find(c) != std::string_view::npos; }

/// Length of the style at the start of `svg` that says what holds anyway; 0 = none. All our corners are round, so that
/// the limit of mitres means nothing.
std::size_t default_length(std::string_view svg) noexcept {
  static constexpr std::string_view kDefaults[] = {"stroke:none;",         "fill-rule:nonzero;",
                                                   "fill-opacity:1;",      "stroke-opacity:1;",
                                                   "stroke-linecap:butt;", "stroke-miterlimit:10;"};
  if (svg.empty() || (svg[0] != 's' && svg[0] != 'f')) return 0;
  for (const std::string_view text : kDefaults)
    if (svg.starts_with(text)) return text.size();
  return 0;
}

/// Copies Cairo's markup, leaving out defaults, rounding what looks like a decimal number and renaming ids where they
/// are made and used.
std::string copy_markup(std::string_view svg, std::string_view id_prefix) {
  static constexpr std::string_view kIdMarks[] = {"id=\"", "href=\"#", "url(#"};
  Ids ids(id_prefix);
  std::string result;
  result.reserve(svg.size());
  for (std::size_t i = 0; i < svg.size();) {
    std::size_t end = i + 1;
    if (is_digit(svg[i]) && i > 0 && before_number(svg[i - 1])) {
      while (end < svg.size() && (is_digit(svg[end]) || svg[end] == '.')) ++end;
      result += rounded(svg.substr(i, end - i));
      i = end;
      continue;
    }
    if (const std::size_t length = default_length(svg.substr(i)); length > 0) {
      i += length;
      continue;
    }
    for (const std::string_view mark : kIdMarks)
      if (svg.substr(i, mark.size()) == mark) end = i + mark.size();
    result += svg.substr(i, end - i);
    if (end > i + 1) {
      const std::size_t stop = std::min(svg.find_first_of("\")", end), svg.size());
      result += ids.renamed(svg.substr(end, stop - end));
      end = stop;
    }
    i = end;
  }
  return result;
}

std::string text_element(const PlacedText& text) {
  static constexpr std::string_view kAnchors[] = {"start", "middle", "end"};
  const Colour& c = text.style.colour;
  const auto byte = [](double part) { return static_cast<int>(part * 255 + 0.5); };
  const std::string turn =
      text.style.upright ? fmt::format(" transform=\"rotate(-90 {:.2f} {:.2f})\"", text.place.x, text.place.y) : "";
  return fmt::format(
      "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{}\"{} text-anchor=\"{}\" textLength=\"{:.1f}\" "
      "lengthAdjust=\"spacingAndGlyphs\" fill=\"#{:02x}{:02x}{:02x}\"{}>{}</text>\n",
      text.place.x, text.place.y, text.style.size_px, text.style.bold ? " font-weight=\"bold\"" : "",
      kAnchors[static_cast<std::size_t>(text.anchor)], text.width_px, byte(c.red), byte(c.green), byte(c.blue), turn,
      escape_markup(text.text));
}

constexpr std::string_view kFontFamily = "font-family=\"'DejaVu Sans', Verdana, sans-serif\"";

/// Cairo's file in its parts.
struct Parts {
  std::string_view header;      ///< Before <svg
  std::string_view attributes;  ///< Of <svg, with the closing '>'
  std::string_view body;
};

Parts parts_of(std::string_view svg) {
  const std::size_t tag = svg.find("<svg ");
  const std::size_t body = svg.find('>', tag) + 1;
  const std::size_t end = svg.rfind("</svg>");
  return {svg.substr(0, tag), svg.substr(tag + 5, body - tag - 5), svg.substr(body, end - body)};
}

std::string text_group(std::span<const PlacedText> texts, std::string_view tag) {
  std::string group = fmt::format("<g {}", kFontFamily);
  if (!tag.empty()) group += fmt::format(" class=\"said-{0}\" lang=\"{0}\"", tag);
  group += ">\n";
  for (const PlacedText& text : texts) group += text_element(text);
  return group + "</g>\n";
}

}  // namespace

std::string finish_svg(std::string_view cairo_svg, std::span<const PlacedText> texts, std::string_view title,
                       std::string_view description) {
  const Parts parts = parts_of(cairo_svg);
  return fmt::format(
      "{}<svg role=\"img\" aria-labelledby=\"title\" aria-describedby=\"desc\" {}\n<title id=\"title\">{}</title>\n"
      "<desc id=\"desc\">{}</desc>{}{}</svg>\n",
      parts.header, parts.attributes, escape_markup(clean_text(title)), escape_markup(clean_text(description)),
      copy_markup(parts.body, ""), text_group(texts, ""));
}

bool same_shapes(std::string_view cairo_svg, std::string_view other) {
  return copy_markup(cairo_svg, "") == copy_markup(other, "");
}

std::string inline_svg(std::string_view cairo_svg, std::span<const SaidTexts> said, std::string_view id_prefix) {
  const Parts parts = parts_of(cairo_svg);
  const std::size_t view_box = parts.attributes.find("viewBox=");
  const std::size_t end = parts.attributes.find('"', view_box + 9) + 1;
  std::string result = fmt::format("<svg role=\"img\" aria-labelledby=\"{}caption\" {}>", id_prefix,
                                   parts.attributes.substr(view_box, end - view_box));
  result += copy_markup(parts.body, id_prefix);
  for (const SaidTexts& one : said) result += text_group(one.texts, one.tag);
  return result + "</svg>";
}

}  // namespace ganglion::plot
