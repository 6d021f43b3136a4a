#include "ganglion/run/criterion.h"

#include <algorithm>
#include <array>
#include <limits>

#include "ganglion/base/text.h"

namespace ganglion {
namespace {

constexpr std::array<std::string_view, 5> kRelations = {"<", "<=", "==", ">=", ">"};

/// Letters, digits and _, a letter first: what a measure may be called.
bool is_name(std::string_view word) noexcept {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return !word.empty() && letter(word.front()) &&
         std::all_of(word.begin(), word.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

}  // namespace

double measure(const Measures& measures, std::string_view name) noexcept {
  for (const auto& [key, value] : measures) {
    if (key == name) return value;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

bool Criterion::met(const Measures& measures) const noexcept {
  const double value = measure(measures, name);
  const double bound = times.empty() ? this->bound : this->bound * measure(measures, times);
  switch (relation) {
    case Relation::Less:
      return value < bound;
    case Relation::AtMost:
      return value <= bound;
    case Relation::Equal:
      return value == bound;
    case Relation::AtLeast:
      return value >= bound;
    case Relation::Greater:
      return value > bound;
  }
  return false;
}

std::string Criterion::text() const {
  std::string right = shortest(bound);
  if (!times.empty()) right = bound == 1 ? times : fmt::format("{} * {}", right, times);
  return fmt::format("{} {} {}", name, kRelations[static_cast<std::size_t>(relation)], right);
}

std::string text_of(const std::vector<Criterion>& criteria) {
  std::string text;
  for (const Criterion& criterion : criteria) text += (text.empty() ? "" : "; ") + criterion.text();
  return text;
}

Result<Criterion> parse_criterion(std::string_view text) {
  std::vector<std::string> words;
  for (const std::string& word : split(text, ' ')) {
    if (!trimmed(word).empty()) words.emplace_back(trimmed(word));
  }
  const bool product = words.size() == 5 && words[3] == "*";
  const bool right = words.size() == 3 || product;
  const auto relation = right ? std::find(kRelations.begin(), kRelations.end(), words[1]) : kRelations.end();
  const auto number = right ? parse_number(words[2]) : std::nullopt;
  if (relation == kRelations.end() || (product && !number) || (!number && !is_name(words[2])) ||
      (product && !is_name(words[4]))) {
    return fail(ErrorCode::Syntax,
                {"\"{}\": write a measure, <, <=, ==, >= or >, and a number or a measure, as in \"contacts <= 3\" or "
                 "\"goals_reached >= 0.95 * goals_set\"",
                 "\"{}\": escriba una medida, <, <=, ==, >= o >, y un número o una medida, como en \"contacts <= 3\" o "
                 "\"goals_reached >= 0.95 * goals_set\""},
                text);
  }
  Criterion criterion{words[0], static_cast<Criterion::Relation>(relation - kRelations.begin()), number.value_or(1)};
  if (product) criterion.times = words[4];
  if (!number) criterion.times = words[2];
  return criterion;
}

}  // namespace ganglion
