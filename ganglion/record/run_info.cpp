#include "ganglion/record/run_info.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "ganglion/base/text.h"

namespace ganglion {
namespace {

constexpr std::string_view kVersion = "version.";
constexpr std::string_view kMeasure = "measure.";
constexpr std::string_view kDigest = "digest.";
constexpr std::string_view kSuccess = "success";
constexpr std::string_view kReasonEs = "reason_es";
constexpr std::string_view kCriterion = "criterion";
constexpr std::string_view kInterventions = "interventions";

/// Gathers the first thing wrong while fields are taken one by one.
class FieldTaker {
 public:
  FieldTaker(const mcap::Fields& fields, std::string_view record) : fields_(fields), record_(record) {}

  std::string text(std::string_view key) {
    const auto found = find(key);
    if (found != fields_.end()) return found->second;
    complain({"has no field \"{}\"", "no tiene el campo \"{}\""}, key);
    return {};
  }

  template <class Integer>
  Integer integer(std::string_view key) {
    const std::string word = text(key);
    Integer value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) {
      complain({"has {} = \"{}\", which is no whole number in range",
                "tiene {} = \"{}\", que no es un número entero admitido"},
               key, word);
    }
    return value;
  }

  double number(std::string_view key, std::string_view word) {
    const auto value = parse_number(word);
    if (!value) complain({"has {} = \"{}\", which is no number", "tiene {} = \"{}\", que no es un número"}, key, word);
    return value.value_or(0);
  }

  /// NotJudged where there is no such field.
  Verdict verdict(std::string_view key) {
    const auto found = find(key);
    if (found == fields_.end()) return Verdict::NotJudged;
    for (const Verdict verdict : {Verdict::Succeeded, Verdict::Failed}) {
      if (found->second == success_word(verdict)) return verdict;
    }
    complain({"has {} = \"{}\"; valid: true, false", "tiene {} = \"{}\"; válidos: true, false"}, key, found->second);
    return Verdict::NotJudged;
  }

  template <class T>
  Result<T> result(T value) const {
    if (!complaint_) return value;
    return fail(ErrorCode::Corrupt, {"metadata \"{}\" {}", "el registro de metadatos \"{}\" {}"}, record_, *complaint_);
  }

 private:
  mcap::Fields::const_iterator find(std::string_view key) const {
    return std::find_if(fields_.begin(), fields_.end(), [&](const auto& field) { return field.first == key; });
  }
  template <class... Args>
  void complain(Wording<std::type_identity_t<Args>...> words, const Args&... args) {
    if (!complaint_) complaint_ = say<Args...>(words, args...);
  }
  const mcap::Fields& fields_;
  std::string_view record_;
  std::optional<Sentence> complaint_;
};

}  // namespace

mcap::Fields to_fields(const RunInfo& info) {
  mcap::Fields fields = {{"name", info.name},
                         {"seed", std::to_string(info.seed)},
                         {"episode", std::to_string(info.episode)},
                         {"tick_s", shortest(info.tick_s)},
                         {"controller_hash", info.controller_hash},
                         {"robots", to_lines(info.robots)}};
  for (const auto& [name, version] : info.versions) fields.emplace_back(std::string(kVersion) + name, version);
  return fields;
}

mcap::Fields to_fields(const RunOutcome& outcome) {
  mcap::Fields fields = {{"digest", outcome.digest}};
  if (outcome.verdict != Verdict::NotJudged) fields.emplace_back(kSuccess, success_word(outcome.verdict));
  fields.emplace_back("reason", outcome.reason.en);
  if (!outcome.reason.es.empty()) fields.emplace_back(kReasonEs, outcome.reason.es);
  if (!outcome.criterion.empty()) fields.emplace_back(kCriterion, outcome.criterion);
  for (const auto& [name, value] : outcome.measures) fields.emplace_back(std::string(kMeasure) + name, shortest(value));
  if (outcome.interventions > 0) fields.emplace_back(kInterventions, std::to_string(outcome.interventions));
  for (const auto& [name, digest] : outcome.component_digests) fields.emplace_back(std::string(kDigest) + name, digest);
  return fields;
}

Result<RunInfo> run_info_from(const mcap::Fields& fields) {
  FieldTaker taker(fields, kRunMetadata);
  RunInfo info;
  info.name = taker.text("name");
  info.seed = taker.integer<std::uint64_t>("seed");
  info.episode = taker.integer<std::uint32_t>("episode");
  info.tick_s = taker.number("tick_s", taker.text("tick_s"));
  info.controller_hash = taker.text("controller_hash");
  info.robots = from_lines(taker.text("robots"));
  for (const auto& [key, value] : fields) {
    if (key.starts_with(kVersion)) info.versions[key.substr(kVersion.size())] = value;
  }
  return taker.result(std::move(info));
}

Result<RunOutcome> run_outcome_from(const mcap::Fields& fields) {
  FieldTaker taker(fields, kOutcomeMetadata);
  RunOutcome outcome;
  outcome.digest = taker.text("digest");
  outcome.verdict = taker.verdict(kSuccess);
  outcome.reason.en = taker.text("reason");
  for (const auto& [key, value] : fields) {
    if (key == kReasonEs) outcome.reason.es = value;
    if (key == kCriterion) outcome.criterion = value;
    if (key == kInterventions) outcome.interventions = taker.integer<std::size_t>(key);
    if (key.starts_with(kMeasure)) outcome.measures.emplace_back(key.substr(kMeasure.size()), taker.number(key, value));
    if (key.starts_with(kDigest)) outcome.component_digests.emplace_back(key.substr(kDigest.size()), value);
  }
  return taker.result(std::move(outcome));
}

std::string to_lines(const std::vector<std::string>& words) {
  std::string lines;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) lines += '\n';
    for (const char c : words[i]) lines += c == '\n' ? ' ' : c;
  }
  return lines;
}

std::vector<std::string> from_lines(std::string_view lines) {
  return lines.empty() ? std::vector<std::string>() : split(lines, '\n');
}

}  // namespace ganglion
