#include "results_json.h"

#include <nlohmann/json.hpp>

#include "ganglion/run/batch.h"

namespace ganglion {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// Nulls where nobody knows.
Json contacts_json(const Contacts& contacts) {
  return {{"count", contacts.known ? Json(contacts.count) : Json(nullptr)},
          {"fastest_mps", contacts.known ? number(contacts.fastest_mps) : Json(nullptr)}};
}

Json run_json(const RunResult& result) {
  Json measures = Json::object();
  for (const auto& [name, value] : result.measures) measures[name] = number(value);
  return {{"seed", result.seed},
          {"success", result.success},
          {"reason", result.reason},
          {"digest", result.digest},
          {"contacts", contacts_json(result.contacts)},
          {"measures", measures},
          {"files", result.files}};
}

std::size_t succeeded(const std::vector<RunResult>& results) {
  return static_cast<std::size_t>(
      std::count_if(results.begin(), results.end(), [](const RunResult& result) { return result.success; }));
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
std::string measures_table(const std::vector<Quartiles>& measures, bool one_run) {
  std::string text = one_run ? fmt::format("{:<26}{:>12}\n", "measure", "value")
                             : fmt::format("{:<26}{:>12}{:>12}{:>12}\n", "measure", "lower", "median", "upper");
  for (const Quartiles& one : measures) {
    text += one_run ? fmt::format("{:<26}{:>12.4g}\n", one.name, one.median)
                    : fmt::format("{:<26}{:>12.4g}{:>12.4g}{:>12.4g}\n", one.name, one.lower, one.median, one.upper);
  }
  return text;
}

}  // namespace

std::string results_json(const std::vector<RunResult>& results) {
  Json runs = Json::array();
  for (const RunResult& result : results) runs.push_back(run_json(result));
  const Json summary = {
      {"count", results.size()}, {"succeeded", succeeded(results)}, {"quartiles", quartiles_json(quartiles(results))}};
  return Json{{"runs", runs}, {"summary", summary}}.dump(2) + "\n";
}

std::string results_table(const std::vector<RunResult>& results) {
  std::string text = fmt::format("{:>6}  {:<8}{:<18}{:>9}{:>14}  {}\n", "seed", "success", "digest", "contacts",
                                 "fastest [m/s]", "reason");
  for (const RunResult& result : results) {
    const bool known = result.contacts.known;
    text += fmt::format("{:>6}  {:<8}{:<18}{:>9}{:>14}  {}\n", result.seed, result.success ? "yes" : "no",
                        result.digest, known ? fmt::format("{}", result.contacts.count) : "-",
                        known ? fmt::format("{:.3f}", result.contacts.fastest_mps) : "-", result.reason);
  }
  text += fmt::format("\n{} of {} succeeded\n", succeeded(results), results.size());
  return text + measures_table(quartiles(results), results.size() == 1);
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

std::string faults_table(const std::vector<FaultRow>& rows) {
  if (rows.empty()) return "interrupted before the first case was done\n";
  std::size_t width = 8;
  for (const FaultRow& row : rows) width = std::max(width, row.name.size() + 2);
  std::string text = fmt::format("{:<{}}{:>6}{:>11}{:>16}", "fault", width, "runs", "succeeded", "of the healthy");
  for (const auto& [criterion, runs] : rows.front().met) text += "  " + criterion;
  text += '\n';
  for (const FaultRow& row : rows) {
    text += fmt::format("{:<{}}{:>6}{:>11}{:>14.0f} %", row.name, width, row.runs, row.succeeded,
                        100 * share_of_healthy(row, rows.front()));
    for (const auto& [criterion, runs] : row.met) text += fmt::format("{:>{}}", runs, criterion.size() + 2);
    text += '\n';
  }
  return text;
}

}  // namespace ganglion
