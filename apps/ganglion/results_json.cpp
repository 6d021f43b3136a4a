#include "results_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
namespace ganglion {
namespace {

using Json = nlohmann::ordered_json;
using lab::FaultRow, lab::Outcome, lab::Quartiles;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// Of the whole outcome what scripts were promised.
Json run_json(const Outcome& outcome) {
  Json whole = lab::outcome_json(outcome), run;
  for (const char* key : {"seed", "success", "reason", "digest", "contacts", "measures", "files"})
    run[key] = std::move(whole[key]);
  return run;
}

std::size_t count(const std::vector<Outcome>& outcomes, Verdict verdict) {
  return static_cast<std::size_t>(std::ranges::count(outcomes, verdict, &Outcome::verdict));
}

Text word_of(Verdict verdict) noexcept {
  if (verdict == Verdict::NotJudged) return {"-", "-"};
  return verdict == Verdict::Succeeded ? Text{"yes", "sí"} : Text{"no", "no"};
}

Json quartiles_json(const std::vector<Quartiles>& quartiles) {
  Json measures = Json::object();
  for (const Quartiles& one : quartiles) {
    measures[one.name] = {{"lower", number(one.lower)}, {"median", number(one.median)}, {"upper", number(one.upper)}};
  }
  return measures;
}

/// Share of successes against the first row's; NaN where the healthy robot never succeeds.
double share_of_healthy(const FaultRow& row, const FaultRow& healthy) {
  const auto share = [](const FaultRow& one) {
    return static_cast<double>(one.succeeded) / static_cast<double>(std::max<std::size_t>(one.runs, 1));
  };
  return healthy.succeeded > 0 ? share(row) / share(healthy) : std::numeric_limits<double>::quiet_NaN();
}

/// Of one run the value, of several the quartiles.
std::string measures_table(const std::vector<Quartiles>& measures, bool one_run, Language language) {
  constexpr Text kMeasure{"measure", "medida"};
  const Sentence head = one_run ? say({"{:<26}{:>12}\n", "{:<26}{:>12}\n"}, kMeasure, Text{"value", "valor"})
                                : say({"{:<26}{:>12}{:>12}{:>12}\n", "{:<26}{:>12}{:>12}{:>12}\n"}, kMeasure,
                                      Text{"lower", "inferior"}, Text{"median", "mediana"}, Text{"upper", "superior"});
  std::string text = head.in(language);
  for (const Quartiles& one : measures) {
    text += one_run ? fmt::format("{:<26}{:>12.4g}\n", one.name, one.median)
                    : fmt::format("{:<26}{:>12.4g}{:>12.4g}{:>12.4g}\n", one.name, one.lower, one.median, one.upper);
  }
  return text;
}

}  // namespace

std::string results_json(const std::vector<Outcome>& outcomes) {
  Json runs = Json::array();
  for (const Outcome& outcome : outcomes) runs.push_back(run_json(outcome));
  const Json summary = {{"count", outcomes.size()},
                        {"succeeded", count(outcomes, Verdict::Succeeded)},
                        {"quartiles", quartiles_json(quartiles(outcomes))}};
  return Json{{"runs", runs}, {"summary", summary}}.dump(2) + "\n";
}

std::string results_table(const std::vector<Outcome>& outcomes, Language language) {
  Sentence text = say({"{:>6}  {:<8}{:<18}{:>9}{:>14}  {}\n", "{:>7}  {:<8}{:<18}{:>9}{:>14}  {}\n"},
                      Text{"seed", "semilla"}, Text{"success", "éxito"}, Text{"digest", "huella"},
                      Text{"contacts", "contactos"}, Text{"fastest [m/s]", "mayor [m/s]"}, Text{"reason", "motivo"});
  for (const Outcome& outcome : outcomes) {
    const bool known = outcome.contacts.known;
    text += say({"{:>6}  {:<8}{:<18}{:>9}{:>14}  {}\n", "{:>7}  {:<8}{:<18}{:>9}{:>14}  {}\n"}, outcome.job.seed,
                word_of(outcome.verdict), outcome.digest, known ? fmt::format("{}", outcome.contacts.count) : "-",
                known ? fmt::format("{:.3f}", outcome.contacts.fastest_mps) : "-", outcome.reason);
  }
  const std::size_t judged = outcomes.size() - count(outcomes, Verdict::NotJudged);
  text += judged > 0
              ? say({"\n{} of {} succeeded\n", "\n{} de {} con éxito\n"}, count(outcomes, Verdict::Succeeded), judged)
              : say({"\nnot judged: the experiment has no criterion of success\n",
                     "\nsin juzgar: el experimento no tiene criterio de éxito\n"});
  return text.in(language) + measures_table(quartiles(outcomes), outcomes.size() == 1, language);
}

std::string faults_json(const std::vector<FaultRow>& rows) {
  Json list = Json::array();
  for (const FaultRow& row : rows) {
    Json met = Json::object();
    for (const auto& [criterion, runs] : row.met) met[criterion] = runs;
    list.push_back({{"name", row.name},
                    {"count", row.runs},
                    {"succeeded", row.succeeded},
                    {"share_of_healthy", number(share_of_healthy(row, rows.front()))},
                    {"met", met},
                    {"quartiles", quartiles_json(row.quartiles)}});
  }
  return Json{{"faults", list}}.dump(2) + "\n";
}

std::string faults_table(const std::vector<FaultRow>& rows, Language language) {
  if (rows.empty()) {
    return say({"interrupted before the first case was done\n", "interrumpida antes de terminar el primer caso\n"})
        .in(language);
  }
  std::size_t width = 8;
  for (const FaultRow& row : rows) width = std::max(width, row.name.size() + 2);
  const auto row_of = [&](const auto& name, const auto& runs, const auto& won, const auto& share) {
    return say({"{:<{}}{:>6}{:>11}{:>16}", "{:<{}}{:>13}{:>11}{:>16}"}, name, width, runs, won, share).in(language);
  };
  std::string text = row_of(Text{"fault", "avería"}, Text{"runs", "ejecuciones"}, Text{"succeeded", "con éxito"},
                            Text{"of the healthy", "del robot sano"});
  for (const auto& [criterion, runs] : rows.front().met) text += "  " + criterion;
  text += '\n';
  for (const FaultRow& row : rows) {
    const double share = share_of_healthy(row, rows.front());
    text += row_of(row.name, row.runs, row.succeeded, std::isnan(share) ? "-" : fmt::format("{:.0f} %", 100 * share));
    for (const auto& [criterion, runs] : row.met) text += fmt::format("{:>{}}", runs, criterion.size() + 2);
    text += '\n';
  }
  return text;
}

}  // namespace ganglion
