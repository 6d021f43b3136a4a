#include "ganglion/run/criterion.h"

#include <algorithm>
#include <array>
#include <limits>

#include "ganglion/base/text.h"

namespace ganglion {
namespace {

constexpr std::array<std::string_view, 5> kRelations = {"<", "<=", "==", ">=", ">"};

}  // namespace

double measure(const Measures& measures, std::string_view name) noexcept {
  for (const auto& [key, value] : measures) {
    if (key == name) return value;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

bool Criterion::met(const Measures& measures) const noexcept {
  const double value = measure(measures, name);
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
  return fmt::format("{} {} {}", name, kRelations[static_cast<std::size_t>(relation)], shortest(bound));
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
  const auto relation =
      words.size() == 3 ? std::find(kRelations.begin(), kRelations.end(), words[1]) : kRelations.end();
  const auto bound = words.size() == 3 ? parse_number(words[2]) : std::nullopt;
  if (relation == kRelations.end() || !bound) {
    return fail(ErrorCode::Syntax,
                {"\"{}\": write a measure, <, <=, ==, >= or >, and a number, as in \"contacts <= 3\"",
                 "\"{}\": escriba una medida, <, <=, ==, >= o >, y un número, como en \"contacts <= 3\""},
                text);
  }
  return Criterion{words[0], static_cast<Criterion::Relation>(relation - kRelations.begin()), *bound};
}

}  // namespace ganglion
