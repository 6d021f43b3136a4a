#include "ganglion/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ganglion/base/file.h"
#include "ganglion/base/text.h"
#include "ganglion/plot/pictures/pictures.h"
#include "ganglion/report/dictionary.h"
#include "ganglion/report/embedded.h"
#include "ganglion/report/html.h"
#include "ganglion/report/player_exhibits.h"
#include "ganglion/report/player_html.h"

namespace ganglion::report {
namespace {

using plot::Language;

constexpr std::size_t kMaxListedEvents = 500;

/// A recorded sentence in both languages; where there is only the English one, it says so to readers aloud.
std::string sentence(const Sentence& said) {
  if (said.es.empty()) return fmt::format("<span lang=\"en\">{}</span>", safe(said.en));
  return fmt::format("<span class=\"said-en\" lang=\"en\">{}</span><span class=\"said-es\" lang=\"es\">{}</span>",
                     safe(said.en), safe(said.es));
}

std::string badge(const plot::RunView& run, Language language) {
  constexpr std::string_view kTick =
      "<path d=\"M4 12l5 5L20 6\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"3\"/>";
  constexpr std::string_view kCross =
      "<path d=\"M5 5l14 14M5 19L19 5\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"3\"/>";
  constexpr std::string_view kDash = "<path d=\"M4 12h16\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"3\"/>";
  struct Look {
    std::string_view style, icon;
    Key word;
  };
  const Look look = !run.outcome                                 ? Look{"cut", kCross, "was_cut"}
                    : run.outcome->verdict == Verdict::NotJudged ? Look{"neutral", kDash, "not_judged"}
                    : run.outcome->verdict == Verdict::Succeeded ? Look{"success", kTick, "succeeded"}
                                                                 : Look{"failure", kCross, "failed"};
  return fmt::format("<p><span class=\"badge {}\"><svg viewBox=\"0 0 24 24\" aria-hidden=\"true\">{}</svg>{}</span>",
                     look.style, look.icon, worded("span", look.word, language)) +
         (run.outcome && !run.outcome->reason.en.empty() ? ": " + sentence(run.outcome->reason) : "") + "</p>\n";
}

std::string header(const plot::RunView& run, Language language) {
  std::string html = fmt::format("<header>\n<div class=\"top\"><h1>{}</h1>", safe(run.name));
  html += worded("button", "other_language", language, "type=\"button\" id=\"language\"") + "</div>\n" +
          badge(run, language);
  if (run.outcome && !run.outcome->criterion.en.empty())
    html += "<p>" + worded("span", "criterion", language) + ": " + sentence(run.outcome->criterion) + "</p>\n";
  html += fmt::format("<p class=\"meta\">{} {} &middot; {} {:.1f} s", worded("span", "seed", language), run.seed,
                      worded("span", "duration", language), run.duration_s);
  if (can_be_watched(run))
    html += fmt::format(" &middot; {} {}", worded("span", "robots", language), run.robots.size());
  if (run.outcome && !run.outcome->digest.empty())
    html +=
        " &middot; " + worded("span", "digest", language) + fmt::format(" <code>{}</code>", safe(run.outcome->digest));
  return html + "</p>\n</header>\n";
}

std::string measures(const plot::RunView& run, Language language) {
  std::string html =
      "<section aria-labelledby=\"measures\">\n" + worded("h2", "measures", language, "id=\"measures\"") + "\n";
  if (run.measures.empty()) return html + worded("p", "no_measures", language) + "</section>\n";
  html += "<table><thead><tr>" + worded("th", "measure", language, "scope=\"col\"") +
          worded("th", "value", language, "scope=\"col\" class=\"number\"") +
          worded("th", "unit", language, "scope=\"col\"") + "</tr></thead><tbody>\n";
  for (const plot::Measure& measure : run.measures) {
    const std::string value =
        std::isnan(measure.value) ? worded("span", "undefined", language) : fmt::format("{:.6g}", measure.value);
    html += fmt::format("<tr><td><code>{}</code></td><td class=\"number\">{}</td><td>{}</td></tr>\n",
                        safe(measure.name), value, unit_of(measure.name));
  }
  return html + "</tbody></table>\n</section>\n";
}

Result<std::string> pictures(const plot::RunView& run, Language language) {
  const std::vector<plot::Picture> english = plot::all_pictures(run, Language::English);
  const std::vector<plot::Picture> spanish = plot::all_pictures(run, Language::Spanish);
  std::string html =
      "<section aria-labelledby=\"pictures\">\n" + worded("h2", "pictures", language, "id=\"pictures\"") + "\n";
  for (std::size_t i = 0; i < english.size(); ++i) {
    const std::string prefix = fmt::format("p{}-", i);
    const auto svg = plot::render_for_page(english[i], spanish[i], prefix);
    if (!svg) return tl::unexpected(svg.error());
    html += fmt::format(
        "<figure><figcaption id=\"{}caption\"><span class=\"said-en\">{}</span><span "
        "class=\"said-es\">{}</span></figcaption>"
        "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-labelledby=\"{}caption\">{}</div></figure>\n",
        prefix, safe(english[i].description), safe(spanish[i].description), prefix, *svg);
  }
  return html + "</section>\n";
}

std::string level_of(plot::Severity severity, Language language) {
  switch (severity) {
    case plot::Severity::Warning:
      return worded("span", "level_warning", language, "class=\"level warning\"");
    case plot::Severity::Error:
      return worded("span", "level_error", language, "class=\"level error\"");
    case plot::Severity::Info:
      break;
  }
  return worded("span", "level_info", language, "class=\"level\"");
}

std::string events(const plot::RunView& run, Language language) {
  if (run.events.empty()) return "";
  std::string html = "<section aria-labelledby=\"events\">\n" + worded("h2", "events", language, "id=\"events\"") +
                     "\n<ul class=\"events\">\n";
  for (std::size_t i = 0; i < std::min(run.events.size(), kMaxListedEvents); ++i) {
    const plot::Event& event = run.events[i];
    const double time_s = std::isfinite(event.time_s) ? event.time_s : 0;
    const std::string time =
        can_be_watched(run) ? fmt::format("<button type=\"button\" data-seek=\"{0:.3f}\">{0:.2f} s</button>", time_s)
                            : fmt::format("<span class=\"time\">{:.2f} s</span>", time_s);
    html += "<li>" + time + level_of(event.severity, language) + sentence(event.text) + "</li>\n";
  }
  html += "</ul>\n";
  if (run.events.size() > kMaxListedEvents) html += worded("p", "more_events", language);
  return html + "</section>\n";
}

}  // namespace

Result<std::string> report_page(const plot::RunView& run, const ReportOptions& options) {
  const auto drawn = pictures(run, options.language);
  if (!drawn) return tl::unexpected(drawn.error());
  const bool watched = can_be_watched(run);
  const std::string body = roles_style() + header(run, options.language) + "<main>\n" +
                           (watched ? player_section(run, options.language) : "") + measures(run, options.language) +
                           *drawn + events(run, options.language) +
                           "</main>\n<script type=\"application/json\" id=\"words\">" + dictionary_json() +
                           "</script>\n";
  return page(run.name, options.language, body, watched ? kPlayerScript : kSwitchScript);
}

Result<void> write_report(const plot::RunView& run, const std::filesystem::path& path, const ReportOptions& options) {
  const auto html = report_page(run, options);
  if (!html) return tl::unexpected(html.error());
  return write_file(path, *html);
}

}  // namespace ganglion::report
