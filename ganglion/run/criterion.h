#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ganglion/base/result.h"

namespace ganglion {

/// Measures by name, units in the names, in the order they were taken.
using Measures = std::vector<std::pair<std::string, double>>;

/// The measure of that name; NaN where there is none.
double measure(const Measures& measures, std::string_view name) noexcept;

/// One line of success or of a stop rule: "fastest_contact_mps <= 0.05".
struct Criterion {
  enum class Relation { Less, AtMost, Equal, AtLeast, Greater };
  std::string name;
  Relation relation = Relation::AtMost;
  double bound = 0;

  /// NaN meets nothing.
  bool met(const Measures& measures) const noexcept;
  std::string text() const;
};

/// All of them, "; " between.
std::string text_of(const std::vector<Criterion>& criteria);

/// Reads "<measure> <relation> <number>" with <, <=, ==, >=, >. Fails with Syntax.
Result<Criterion> parse_criterion(std::string_view text);

}  // namespace ganglion
