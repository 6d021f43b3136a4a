#include "ganglion/lab/outcome.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace ganglion::lab {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 3> kTroubles = {"link", "files", "catalogue"};

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// Nulls where nobody knows.
Json contacts_json(const Contacts& contacts) {
  return {{"count", contacts.known ? Json(contacts.count) : Json(nullptr)},
          {"fastest_mps", contacts.known ? number(contacts.fastest_mps) : Json(nullptr)}};
}

/// What never ends or has no second target says nothing of it.
Json fault_json(const Fault& fault) {
  Json json = {{"target", fault.target},
               {"kind", kFaultNames[static_cast<std::size_t>(fault.kind)]},
               {"amount", fault.amount},
               {"from_s", fault.from_s},
               {"from_latest_s", fault.from_latest_s},
               {"chance", fault.chance}};
  if (std::isfinite(fault.to_s)) json["to_s"] = fault.to_s;
  if (!fault.with.empty()) json["with"] = fault.with;
  return json;
}

Json trouble_json(const Trouble& trouble) {
  const Error& error = trouble.error;
  return {{"of", kTroubles[static_cast<std::size_t>(trouble.of)]},
          {"code", name_of(error.code)},
          {"what", error.what.en},
          {"what_es", error.what.es},
          {"file", error.place.file},
          {"line", error.place.line},
          {"column", error.place.column}};
}

/// The member of that name where it is what is asked for, else a preset.
template <class T>
T member(const Json& object, std::string_view name, T preset, bool (Json::*fits)() const noexcept) {
  const auto found = object.is_object() ? object.find(name) : object.end();
  return found != object.end() && ((*found).*fits)() ? found->template get<T>() : preset;
}
std::string text(const Json& object, std::string_view name) {
  return member(object, name, std::string(), &Json::is_string);
}
template <class T>
T whole(const Json& object, std::string_view name) {
  return member(object, name, T{}, &Json::is_number_unsigned);
}

/// An empty list where there is none.
const Json& list(const Json& object, std::string_view name) {
  static const Json kNone = Json::array();
  const auto found = object.find(name);
  return found != object.end() && found->is_array() ? *found : kNone;
}

Contacts read_contacts(const Json& object) {
  const auto found = object.find("contacts");
  if (found == object.end() || !found->is_object() || !found->contains("count") ||
      !(*found)["count"].is_number_integer())
    return {.known = false};
  return {.known = true,
          .count = (*found)["count"].get<int>(),
          .fastest_mps = member(*found, "fastest_mps", std::nan(""), &Json::is_number)};
}

std::optional<Fault> read_fault(const Json& json) {
  const auto kind = std::find(kFaultNames.begin(), kFaultNames.end(), text(json, "kind"));
  if (kind == kFaultNames.end()) return std::nullopt;
  Fault fault;
  fault.kind = static_cast<FaultKind>(kind - kFaultNames.begin());
  fault.target = text(json, "target");
  fault.with = text(json, "with");
  fault.amount = member(json, "amount", fault.amount, &Json::is_number);
  fault.from_s = member(json, "from_s", fault.from_s, &Json::is_number);
  fault.from_latest_s = member(json, "from_latest_s", fault.from_latest_s, &Json::is_number);
  fault.to_s = member(json, "to_s", fault.to_s, &Json::is_number);
  fault.chance = member(json, "chance", fault.chance, &Json::is_number);
  return fault;
}

ErrorCode code_of(std::string_view name) {
  for (int i = 0; i <= static_cast<int>(ErrorCode::LinkLost); ++i) {
    if (name_of(static_cast<ErrorCode>(i)) == name) return static_cast<ErrorCode>(i);
  }
  return ErrorCode::Unreadable;
}

Trouble read_trouble(const Json& json) {
  Trouble trouble;
  const auto found = std::find(kTroubles.begin(), kTroubles.end(), text(json, "of"));
  if (found != kTroubles.end()) trouble.of = static_cast<Trouble::Of>(found - kTroubles.begin());
  trouble.error.code = code_of(text(json, "code"));
  trouble.error.what.en = text(json, "what");
  trouble.error.what.es = text(json, "what_es");
  trouble.error.place = {text(json, "file"), whole<int>(json, "line"), whole<int>(json, "column")};
  return trouble;
}

}  // namespace

const Error* Outcome::trouble(Trouble::Of of) const noexcept {
  const auto found = std::find_if(troubles.begin(), troubles.end(), [of](const Trouble& one) { return one.of == of; });
  return found != troubles.end() ? &found->error : nullptr;
}

Outcome outcome_of(Job job, const RunResult& result) {
  Outcome outcome{.job = std::move(job),
                  .verdict = result.verdict,
                  .reason = result.reason,
                  .digest = result.digest,
                  .contacts = result.contacts,
                  .figures = result.measures,
                  .interventions = result.interventions,
                  .files = result.files,
                  .troubles = {}};
  outcome.job.seed = result.seed;
  if (result.record_error) outcome.troubles.push_back({Trouble::Of::Files, *result.record_error});
  if (result.link_lost) outcome.troubles.push_back({Trouble::Of::Link, *result.link_lost});
  return outcome;
}

Json outcome_json(const Outcome& outcome) {
  Json figures = Json::object(), set = Json::array(), faults = Json::array(), troubles = Json::array();
  for (const auto& [name, value] : outcome.figures) figures[name] = number(value);
  for (const config::Override& one : outcome.job.overrides) set.push_back(one.path + "=" + one.value);
  for (const Fault& one : outcome.job.faults) faults.push_back(fault_json(one));
  for (const Trouble& one : outcome.troubles) troubles.push_back(trouble_json(one));
  return {
      {"seed", outcome.job.seed},
      {"success", outcome.verdict == Verdict::NotJudged ? Json(nullptr) : Json(outcome.verdict == Verdict::Succeeded)},
      {"reason", outcome.reason.en},
      {"reason_es", outcome.reason.es},
      {"digest", outcome.digest},
      {"contacts", contacts_json(outcome.contacts)},
      {"measures", std::move(figures)},
      {"files", outcome.files},
      {"interventions", outcome.interventions},
      {"experiment", outcome.job.experiment},
      {"set", std::move(set)},
      {"episode", outcome.job.episode},
      {"faults", std::move(faults)},
      {"troubles", std::move(troubles)}};
}

Result<Outcome> read_outcome(const Json& json, std::string_view where) {
  const auto success = json.is_object() ? json.find("success") : json.end();
  const auto measures = json.is_object() ? json.find("measures") : json.end();
  if (success == json.end() || !(success->is_boolean() || success->is_null()) || measures == json.end() ||
      !measures->is_object()) {
    return fail(ErrorCode::BadType,
                {"{} has no \"success\" and \"measures\"", "{} no tiene \"success\" y \"measures\""}, where);
  }
  Outcome outcome;
  if (success->is_boolean()) outcome.verdict = success->get<bool>() ? Verdict::Succeeded : Verdict::Failed;
  for (const auto& [name, value] : measures->items()) {
    if (!value.is_number() && !value.is_null())
      return fail(ErrorCode::BadType, {"{}.measures.{} is no number", "{}.measures.{} no es un número"}, where, name);
    outcome.figures.emplace_back(name, value.is_null() ? std::nan("") : value.get<double>());
  }
  outcome.job.experiment = text(json, "experiment");
  outcome.job.seed = whole<std::uint64_t>(json, "seed");
  outcome.job.episode = whole<std::uint32_t>(json, "episode");
  for (const Json& one : list(json, "set")) {
    if (!one.is_string()) continue;
    if (auto set = config::parse_override(one.get<std::string>())) outcome.job.overrides.push_back(std::move(*set));
  }
  for (const Json& one : list(json, "faults")) {
    if (auto fault = read_fault(one)) outcome.job.faults.push_back(std::move(*fault));
  }
  outcome.reason = {text(json, "reason"), text(json, "reason_es")};
  outcome.digest = text(json, "digest");
  outcome.contacts = read_contacts(json);
  outcome.interventions = whole<std::size_t>(json, "interventions");
  for (const Json& one : list(json, "files")) {
    if (one.is_string()) outcome.files.push_back(one.get<std::string>());
  }
  for (const Json& one : list(json, "troubles")) {
    if (one.is_object()) outcome.troubles.push_back(read_trouble(one));
  }
  return outcome;
}

}  // namespace ganglion::lab
