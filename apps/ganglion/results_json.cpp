#include "results_json.h"

#include <nlohmann/json.hpp>

#include "ganglion/run/batch.h"

namespace ganglion {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json run_json(const RunResult& result) {
  Json measures = Json::object();
  for (const auto& [name, value] : result.measures) measures[name] = number(value);
  return {{"seed", result.seed},
          {"success", result.success},
          {"reason", result.reason},
          {"digest", result.digest},
          {"contacts", {{"count", result.contacts.count}, {"fastest_mps", number(result.contacts.fastest_mps)}}},
          {"measures", measures},
          {"files", result.files}};
}

std::size_t succeeded(const std::vector<RunResult>& results) {
  return static_cast<std::size_t>(
      std::count_if(results.begin(), results.end(), [](const RunResult& result) { return result.success; }));
}

}  // namespace

std::string results_json(const std::vector<RunResult>& results) {
  Json runs = Json::array();
  for (const RunResult& result : results) runs.push_back(run_json(result));
  Json measures = Json::object();
  for (const Quartiles& one : quartiles(results)) {
    measures[one.name] = {{"lower", number(one.lower)}, {"median", number(one.median)}, {"upper", number(one.upper)}};
  }
  const Json summary = {{"count", results.size()}, {"succeeded", succeeded(results)}, {"quartiles", measures}};
  return Json{{"runs", runs}, {"summary", summary}}.dump(2) + "\n";
}

std::string results_table(const std::vector<RunResult>& results) {
  std::string text = fmt::format("{:>6}  {:<8}{:<18}{:>9}{:>14}  {}\n", "seed", "success", "digest", "contacts",
                                 "fastest [m/s]", "reason");
  for (const RunResult& result : results) {
    text += fmt::format("{:>6}  {:<8}{:<18}{:>9}{:>14.3f}  {}\n", result.seed, result.success ? "yes" : "no",
                        result.digest, result.contacts.count, result.contacts.fastest_mps, result.reason);
  }
  text += fmt::format("\n{} of {} succeeded\n{:<26}{:>12}{:>12}{:>12}\n", succeeded(results), results.size(), "measure",
                      "lower", "median", "upper");
  for (const Quartiles& one : quartiles(results)) {
    text += fmt::format("{:<26}{:>12.4g}{:>12.4g}{:>12.4g}\n", one.name, one.lower, one.median, one.upper);
  }
  return text;
}

}  // namespace ganglion
