#pragma once

#include <limits>

#include "ganglion/base/sentence.h"

namespace ganglion::config {

/// What a number must satisfy; both ends belong to the range unless `above` excludes the lower one.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool above_min = false;
};
/// "> 0", ">= 1", "in [0, 1]".
Sentence text_of(const Range& range);
inline constexpr Range kPositive{0, std::numeric_limits<double>::infinity(), true};
inline constexpr Range kNotNegative{0};

}  // namespace ganglion::config
