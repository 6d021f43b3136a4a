#include "ganglion/plot/testing/markup.h"

namespace ganglion::plot {
namespace {

/// The tag that begins at `open`, up to and with its '>'; quotes may hold one. Empty where it is cut.
std::string_view tag_at(std::string_view markup, std::size_t open) {
  char quote = 0;
  for (std::size_t i = open; i < markup.size(); ++i) {
    const char c = markup[i];
    if (quote != 0)
      quote = c == quote ? '\0' : quote;
    else if (c == '"' || c == '\'')
      quote = c;
    else if (c == '>')
      return markup.substr(open, i - open + 1);
  }
  return {};
}

}  // namespace

std::string fault_in_markup(std::string_view markup) {
  std::vector<std::string_view> open;
  for (std::size_t at = markup.find('<'); at != std::string_view::npos; at = markup.find('<', at)) {
    const std::string_view tag = tag_at(markup, at);
    if (tag.empty()) return "a tag is cut: " + std::string(markup.substr(at, 40));
    at += tag.size();
    if (tag[1] == '?' || tag[1] == '!' || tag.ends_with("/>")) continue;
    const bool closes = tag[1] == '/';
    const std::size_t name = closes ? 2 : 1;
    const std::string_view word = tag.substr(name, tag.find_first_of(" >\n", name) - name);
    if (!closes) {
      open.push_back(word);
    } else if (open.empty() || open.back() != word) {
      return "nothing to close for " + std::string(tag);
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : "left open: " + std::string(open.back());
}

std::vector<std::string> texts_in(std::string_view svg) {
  std::vector<std::string> texts;
  for (std::size_t at = svg.find("<text "); at != std::string_view::npos; at = svg.find("<text ", at)) {
    const std::size_t start = svg.find('>', at) + 1;
    const std::size_t end = svg.find("</text>", start);
    texts.emplace_back(svg.substr(start, end - start));
    at = end;
  }
  return texts;
}

std::set<std::string> words_in(const Picture& picture) {
  const auto svg = render(picture, PictureFormat::Svg);
  const auto texts = texts_in(svg.value_or(""));
  return {texts.begin(), texts.end()};
}

}  // namespace ganglion::plot
