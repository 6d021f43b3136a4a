#include "ganglion/report/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ganglion/base/file.h"
#include "ganglion/math/quantile.h"
#include "ganglion/report/dictionary.h"
#include "ganglion/report/embedded.h"
#include "ganglion/report/html.h"

namespace ganglion::report {
namespace {

using plot::Language;

/// The quartiles of one measure in one batch.
struct Quartiles {
  double first = 0;
  double median = 0;
  double third = 0;
  std::size_t missing = 0;  ///< Runs without a value.
};

Quartiles quartiles_of(const NamedBatch& batch, const std::string& measure) {
  std::vector<double> values;
  for (const BatchRun& run : batch.runs) {
    const auto found = std::ranges::find(run.measures, measure, &std::pair<std::string, double>::first);
    if (found != run.measures.end() && !std::isnan(found->second)) values.push_back(found->second);
  }
  return {math::quantile(values, 0.25), math::quantile(values, 0.5), math::quantile(values, 0.75),
          batch.runs.size() - values.size()};
}

/// Every measure's name once, in the order it first appears.
std::vector<std::string> measures_of(std::span<const NamedBatch> batches) {
  std::vector<std::string> names;
  for (const NamedBatch& batch : batches)
    for (const BatchRun& run : batch.runs)
      for (const auto& [name, value] : run.measures)
        if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  return names;
}

std::string head(std::initializer_list<Key> keys, Language language) {
  std::string html = "<thead><tr>";
  for (std::size_t i = 0; i < keys.size(); ++i)
    html +=
        worded("th", keys.begin()[i], language,
               i == 0 || std::string_view(keys.begin()[i].entry().key) == "spread" ? "scope=\"col\""
                                                                                   : "scope=\"col\" class=\"number\"");
  return html + "</tr></thead>\n";
}

std::string number(double value, Language language) {
  if (std::isnan(value)) return "<td class=\"number\">" + worded("span", "undefined", language) + "</td>";
  return fmt::format("<td class=\"number\">{:.4g}</td>", value);
}

std::string shares(std::span<const NamedBatch> batches, Language language) {
  std::string html = "<section aria-labelledby=\"shares\">\n" + worded("h2", "successes", language, "id=\"shares\"") +
                     "\n<div class=\"scroll\"><table>" +
                     head({"batch", "runs", "successes", "share", "interval"}, language) + "<tbody>\n";
  for (const NamedBatch& batch : batches) {
    html +=
        fmt::format("<tr><th scope=\"row\">{}</th><td class=\"number\">{}</td>", safe(batch.name), batch.runs.size());
    const auto [judged, won] = successes_of(batch);
    if (judged == 0) {
      for (int cell = 0; cell < 3; ++cell) html += "<td class=\"number\">-</td>";
    } else {
      const Interval interval = wilson(won, judged);
      html += fmt::format("<td class=\"number\">{}</td>{}<td class=\"number\">{:.3f} &ndash; {:.3f}</td>", won,
                          number(static_cast<double>(won) / static_cast<double>(judged), language), interval.lower,
                          interval.upper);
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n</section>\n";
}

/// A bar from the first to the third quartile, all batches on one scale.
std::string spread(const Quartiles& q, double lower, double upper) {
  const double range = upper - lower;
  if (!std::isfinite(q.first) || !std::isfinite(q.third) || !std::isfinite(range)) return "<td></td>";
  const auto at = [&](double value) { return range > 0 ? 4 + (value - lower) / range * 152 : 80; };
  return fmt::format(
      "<td><svg viewBox=\"0 0 160 18\" width=\"160\" height=\"18\" aria-hidden=\"true\"><path d=\"M2 9H158\" "
      "stroke=\"var(--edge)\"/><rect x=\"{:.1f}\" y=\"4\" width=\"{:.1f}\" height=\"10\" fill=\"var(--look-6)\"/>"
      "<path d=\"M{:.1f} 1v16\" stroke=\"var(--text)\" stroke-width=\"2.5\"/></svg></td>",
      at(q.first), std::max(1.0, at(q.third) - at(q.first)), at(q.median));
}

std::string measure_section(std::span<const NamedBatch> batches, const std::string& name, Language language) {
  std::vector<Quartiles> all;
  double lower = INFINITY, upper = -INFINITY;
  for (const NamedBatch& batch : batches) {
    all.push_back(quartiles_of(batch, name));
    for (const double value : {all.back().first, all.back().third})
      if (std::isfinite(value)) lower = std::min(lower, value), upper = std::max(upper, value);
  }
  const std::string_view unit = unit_of(name);
  std::string html = fmt::format("<section><h2><code>{}</code>{}</h2>\n<div class=\"scroll\"><table>", safe(name),
                                 unit.empty() ? "" : fmt::format(" [{}]", unit));
  html += head({"batch", "quartile_1", "median", "quartile_3", "without_value", "spread"}, language) + "<tbody>\n";
  for (std::size_t i = 0; i < all.size(); ++i)
    html += fmt::format("<tr><th scope=\"row\">{}</th>{}{}{}<td class=\"number\">{}</td>{}</tr>\n",
                        safe(batches[i].name), number(all[i].first, language), number(all[i].median, language),
                        number(all[i].third, language), all[i].missing, spread(all[i], lower, upper));
  return html + "</tbody></table></div>\n</section>\n";
}

}  // namespace

Successes successes_of(const NamedBatch& batch) noexcept {
  const auto count = [&](Verdict verdict) {
    return static_cast<std::size_t>(std::ranges::count(batch.runs, verdict, &BatchRun::verdict));
  };
  return {batch.runs.size() - count(Verdict::NotJudged), count(Verdict::Succeeded)};
}

Interval wilson(std::size_t successes, std::size_t runs) noexcept {
  if (runs == 0) return {};
  constexpr double kZ = 1.959963984540054;  // 97.5 % of the normal distribution
  const double n = static_cast<double>(runs);
  const double share = static_cast<double>(successes) / n;
  const double middle = share + kZ * kZ / (2 * n);
  const double half = kZ * std::sqrt(share * (1 - share) / n + kZ * kZ / (4 * n * n));
  const double scale = 1 + kZ * kZ / n;
  return {std::max(0.0, (middle - half) / scale), std::min(1.0, (middle + half) / scale)};
}

std::string comparison_page(std::span<const NamedBatch> batches, Language language) {
  std::string body = "<header>\n<div class=\"top\">" + worded("h1", "comparison", language) +
                     worded("button", "other_language", language, "type=\"button\" id=\"language\"") + "</div>\n" +
                     worded("p", "about_comparison", language, "class=\"meta\"") + "</header>\n<main>\n" +
                     shares(batches, language);
  for (const std::string& name : measures_of(batches)) body += measure_section(batches, name, language);
  body += "</main>\n<script type=\"application/json\" id=\"words\">" + dictionary_json() + "</script>\n";
  return page(say("comparison", language), language, body, kSwitchScript);
}

Result<void> write_comparison(std::span<const NamedBatch> batches, const std::filesystem::path& path,
                              Language language) {
  return write_file(path, comparison_page(batches, language));
}

}  // namespace ganglion::report
