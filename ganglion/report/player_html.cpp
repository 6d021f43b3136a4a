#include "ganglion/report/player_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "ganglion/report/html.h"
#include "ganglion/report/legend_html.h"
#include "ganglion/report/player_data.h"

namespace ganglion::report {
namespace {

using plot::Language;

constexpr std::size_t kMostChoices = 60;
constexpr double kForEver = std::numeric_limits<double>::infinity();

/// A value that holds a line break, which safe() would take out.
std::string safe_value(const std::string& text) {
  const std::size_t cut = text.find('\n');
  return safe(text.substr(0, cut)) + "&#10;" + safe(text.substr(cut + 1));
}

constexpr std::string_view kPlayIcon =
    "<svg class=\"icon-play\" viewBox=\"0 0 20 20\" aria-hidden=\"true\"><path d=\"M5 2l13 8-13 8z\"/></svg>";
constexpr std::string_view kPauseIcon =
    "<svg class=\"icon-pause\" viewBox=\"0 0 20 20\" aria-hidden=\"true\"><path d=\"M4 2h4v16H4zM12 "
    "2h4v16h-4z\"/></svg>";
constexpr std::string_view kBackIcon =
    "<svg viewBox=\"0 0 20 20\" aria-hidden=\"true\"><path d=\"M3 3h3v14H3zM17 3v14L7 10z\"/></svg>";
constexpr std::string_view kForthIcon =
    "<svg viewBox=\"0 0 20 20\" aria-hidden=\"true\"><path d=\"M14 3h3v14h-3zM3 3v14l10-7z\"/></svg>";
constexpr std::string_view kNearerIcon =
    "<svg viewBox=\"0 0 20 20\" aria-hidden=\"true\"><path d=\"M9 3h2v6h6v2h-6v6H9v-6H3V9h6z\"/></svg>";
constexpr std::string_view kFartherIcon =
    "<svg viewBox=\"0 0 20 20\" aria-hidden=\"true\"><path d=\"M3 9h14v2H3z\"/></svg>";

std::string button(std::string_view id, Key key, Language language, std::string_view icons) {
  return fmt::format("<button type=\"button\" id=\"{0}\" {1} title=\"{2}\">{3}</button>\n", id, labelled(key, language),
                     safe(say(key, language)), icons);
}

/// Whether anything of the run may be drawn on a stage.
bool has_place(const plot::RunView& run) { return plot::has_way(run) || run.scene.bounds || !run.exhibits.empty(); }

std::string stage(const plot::RunView& run, Language language) {
  const plot::Bounds bounds = plot::bounds_of(run);
  const Vector2 size = bounds.upper - bounds.lower;
  const double aspect = std::clamp(size.x / size.y, 0.7, 2.4);
  std::string html = fmt::format(
      "<div class=\"stage\"{}>\n<canvas id=\"stage\" role=\"img\" {} style=\"--aspect: {:.3f}\"></canvas>\n",
      has_place(run) ? "" : " hidden", labelled("stage", language), aspect);
  html += fmt::format("<button type=\"button\" id=\"big-play\" {}>{}</button>\n", labelled("play", language),
                      "<svg viewBox=\"0 0 20 20\" aria-hidden=\"true\"><path d=\"M5 2l13 8-13 8z\"/></svg>");
  html += "<div class=\"zoom\">\n" + button("nearer", "nearer", language, kNearerIcon) +
          button("farther", "farther", language, kFartherIcon) + "</div>\n</div>\n";
  return html;
}

std::string controls(Language language) {
  std::string html = "<div class=\"controls\">\n" + button("back", "back", language, kBackIcon) +
                     button("play", "play", language, std::string(kPlayIcon) + std::string(kPauseIcon)) +
                     button("forth", "forth", language, kForthIcon);
  html += fmt::format("<input type=\"range\" id=\"slider\" min=\"0\" max=\"1\" step=\"any\" value=\"0\" {}>\n",
                      labelled("time", language));
  html += "<span id=\"clock\"></span>\n<label>" + worded("span", "speed", language) + " <select id=\"speed\">";
  for (const std::string_view speed : {"0.1", "0.25", "0.5", "1", "2", "5", "10", "20"})
    html += fmt::format("<option value=\"{0}\"{1}>{0}x</option>", speed, speed == "1" ? " selected" : "");
  return html + "</select></label>\n</div>\n";
}

std::string switch_for(std::string_view layer, Key key, Language language) {
  return fmt::format("<label><input type=\"checkbox\" data-layer=\"{}\" checked> {}</label>\n", layer,
                     worded("span", key, language));
}

/// A choice among all layers of all fields that lie in a frame; those of a name count as one, whoever shows them.
std::string field_choice(const plot::RunView& run, Language language) {
  std::string options;
  std::set<std::string> seen;
  bool chosen = false;
  for (const ExhibitTrack& track : run.exhibits) {
    const auto field = field_at(track, kForEver);
    if (!field || field->frame.empty()) continue;
    for (const shown::Layer& layer : field->layers) {
      const std::string value = track.name + "\n" + layer.name;
      if (!seen.insert(value).second || seen.size() > kMostChoices) continue;
      const bool first = !chosen && layer.classes.empty();
      chosen = chosen || first;
      const Sentence words{track.title().en + ": " + layer.title.en, track.title().es + ": " + layer.title.es};
      options += recorded("option", words, language,
                          fmt::format("value=\"{}\"{}", safe_value(value), first ? " selected" : ""));
    }
  }
  if (options.empty()) return "";
  return "<label>" + worded("span", "field", language) + " <select data-layer=\"field\">" + options +
         worded("option", "field_off", language, "value=\"\"") + "</select></label>\n";
}

/// A switch for the marks of each name.
std::string mark_switches(const plot::RunView& run, Language language) {
  std::string html;
  std::set<std::string> seen;
  for (const ExhibitTrack& track : run.exhibits) {
    if (track.form != "marks" || !seen.insert(track.name).second || seen.size() > kMostChoices) continue;
    html += fmt::format("<label><input type=\"checkbox\" data-layer=\"marks-{}\" checked> {}</label>\n",
                        safe(track.name), recorded("span", track.title(), language));
  }
  return html;
}

std::string robot_choice(const plot::RunView& run, Language language) {
  std::string html = fmt::format("<label{}>", run.robots.size() < 2 ? " hidden" : "");
  html += worded("span", "robot", language) + " <select id=\"robot\">";
  for (std::size_t i = 0; i < run.robots.size(); ++i)
    html += fmt::format("<option value=\"{}\">{}</option>", i, safe(run.robots[i].name));
  return html + "</select></label>\n";
}

std::string layers(const plot::RunView& run, Language language) {
  const Content content = content_of(run);
  std::string html = fmt::format("<div class=\"layers\" role=\"group\" {}>\n", labelled("layers", language));
  html += robot_choice(run, language);
  if (plot::has_way(run)) html += switch_for("trail", "trail", language);
  if (content.sensors) html += switch_for("sonar", "sonar", language);
  html += field_choice(run, language) + mark_switches(run, language);
  if (content.movers) html += switch_for("movers", "movers", language);
  return html + "</div>\n";
}

std::string keys(Language language) {
  return fmt::format(
      "<p class=\"keys\">{}: <kbd>{}</kbd> {}, <kbd>,</kbd> <kbd>.</kbd> {}, <kbd>&larr;</kbd> <kbd>&rarr;</kbd> {}; "
      "{}</p>\n",
      worded("span", "keys", language), worded("span", "key_space", language), worded("span", "key_play", language),
      worded("span", "key_step", language), worded("span", "key_second", language),
      worded("span", "key_zoom", language));
}

}  // namespace

bool can_be_watched(const plot::RunView& run) { return has_place(run) || content_of(run).behaviours; }

std::string player_section(const plot::RunView& run, Language language) {
  std::string html = "<section aria-labelledby=\"watch\">\n" + worded("h2", "watch", language, "id=\"watch\"") + "\n";
  html += "<noscript>" + worded("p", "needs_script", language) + "</noscript>\n";
  html += stage(run, language);
  html += fmt::format("<canvas id=\"bands\" role=\"img\" {}></canvas>\n", labelled("bands", language));
  html += controls(language) + layers(run, language) + "<div id=\"panels\"></div>\n";
  html += "<div class=\"now\"><span id=\"behaviour\"><span id=\"behaviour-swatch\"></span>" +
          worded("span", "drives", language) +
          " <span id=\"behaviour-name\"></span></span><span id=\"place\"></span></div>\n<dl id=\"readings\"></dl>\n"
          "<p class=\"told\" id=\"told\" role=\"status\"></p>\n";
  html += legend_html(run, language) + keys(language);
  html += "<script type=\"application/json\" id=\"run\">" + player_data(run) + "</script>\n</section>\n";
  return html;
}

}  // namespace ganglion::report
