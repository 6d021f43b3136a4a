#include "ganglion/report/html.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "ganglion/base/hash.h"
#include "ganglion/plot/canvas/picture.h"
#include "ganglion/report/embedded.h"

namespace ganglion::report {

std::string safe(std::string_view text) { return plot::escape_markup(plot::clean_text(text)); }

std::string worded(std::string_view tag, Key key, plot::Language language, std::string_view attributes) {
  return fmt::format("<{0}{1}{2} data-word=\"{3}\">{4}</{0}>", tag, attributes.empty() ? "" : " ", attributes,
                     std::string_view(key.entry().key), safe(say(key, language)));
}

std::string recorded(std::string_view tag, const Sentence& said, plot::Language language, std::string_view attributes) {
  return fmt::format("<{0}{1}{2} lang=\"{3}\" data-en=\"{4}\" data-es=\"{5}\">{6}</{0}>", tag,
                     attributes.empty() ? "" : " ", attributes, plot::tag_of(language), safe(said.en), safe(said.es),
                     safe(said.in(language)));
}

std::string labelled(Key key, plot::Language language) {
  return fmt::format("data-label=\"{}\" aria-label=\"{}\"", std::string_view(key.entry().key),
                     safe(say(key, language)));
}

std::string_view unit_of(std::string_view measure) noexcept {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 16> kUnits{{{"m", "m"},
                                                                                         {"m2", "m²"},
                                                                                         {"mm", "mm"},
                                                                                         {"s", "s"},
                                                                                         {"ms", "ms"},
                                                                                         {"us", "µs"},
                                                                                         {"Hz", "Hz"},
                                                                                         {"mps", "m/s"},
                                                                                         {"mps2", "m/s²"},
                                                                                         {"rad", "rad"},
                                                                                         {"deg", "°"},
                                                                                         {"radps", "rad/s"},
                                                                                         {"percent", "%"},
                                                                                         {"V", "V"},
                                                                                         {"W", "W"},
                                                                                         {"J", "J"}}};
  const std::size_t line = measure.rfind('_');
  if (line == std::string_view::npos) return {};
  for (const auto& [suffix, unit] : kUnits)
    if (measure.substr(line + 1) == suffix) return unit;
  return {};
}

std::string page(std::string_view title, plot::Language language, std::string_view body, std::string_view script) {
  const std::string nonce = fmt::format("{:016x}", combine(hash_name(body), hash_name(script)));
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
      "'unsafe-inline'; "
      "script-src 'nonce-{}'; base-uri 'none'; form-action 'none'\">\n<title>{}</title>\n<style>\n",
      plot::tag_of(language), nonce, safe(title));
  html += kStyle;
  html += "</style>\n</head>\n<body>\n";
  html += body;
  if (!script.empty())
    html += fmt::format("<script nonce=\"{}\">\n(() => {{\n'use strict';\n{}}})();\n</script>\n", nonce, script);
  html += "</body>\n</html>\n";
  return html;
}

}  // namespace ganglion::report
