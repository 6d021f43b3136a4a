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

/// One line of success or of a stop rule: "fastest_contact_mps <= 0.05", "goals_reached >= 0.95 * goals_set".
struct Criterion {
  enum class Relation { Less, AtMost, Equal, AtLeast, Greater };
  std::string name;
  Relation relation = Relation::AtMost;
  double bound = 0;
  std::string times;  ///< The figure that the bound is multiplied with; "" = none.
  Place place{};      ///< Where it is written.

  /// NaN meets nothing.
  bool met(const Measures& measures) const noexcept;
  std::string text() const;
};

/// All of them, "; " between.
std::string text_of(const std::vector<Criterion>& criteria);

/// Reads "<figure> <relation> <bound>" with <, <=, ==, >=, >; the bound is a number, a figure, or "<number> * <figure>".
/// Fails with Syntax.
Result<Criterion> parse_criterion(std::string_view text);

}  // namespace ganglion
