#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"

namespace ganglion {

/// One argument of an intervention.
struct InterventionArgument {
  std::string_view name;  ///< "x_m"
  std::string_view unit;
};

/// Something that a person may do to an application while it runs, between ticks.
struct InterventionDescriptor {
  std::string_view name;  ///< As written in files and JSON: "goal".
  Text title;
  std::string_view subject;  ///< What it takes hold of besides a robot, as JSON names it: "mover"; "" = nothing.
  std::span<const InterventionArgument> arguments;
  int code = 0;  ///< In the digest of an interrupted run. 0 goal, 1 obstacle; others take numbers of their own.
  /// What was done, for people: "goal of robot {robot} set at ({x_m}, {y_m})"; {subject} is what it took hold of.
  Text line;
};

struct NamedNumber {
  std::string name;
  double value = 0;
};

/// One that is done, or is to be.
struct Intervention {
  std::string name;  ///< Of its descriptor.
  int robot = 0;
  std::string subject;
  std::vector<NamedNumber> arguments;

  std::optional<double> argument(std::string_view called) const noexcept;
};

/// What came of one.
struct Intervened {
  std::vector<NamedNumber> arguments;  ///< As they came to be: of a goal the centre of its cell.
  bool reachable = true;               ///< Of a goal: whether a way leads there.

  double argument(std::string_view called) const noexcept;  ///< NaN where there is no such.
};

/// The descriptor of that name, or null.
const InterventionDescriptor* find(std::span<const InterventionDescriptor> list, std::string_view name) noexcept;

/// Every argument that the descriptor names, in its order. Fails with BadParameter where one is missing or no finite
/// number, or where there is one too many.
Result<std::vector<double>> arguments_of(const InterventionDescriptor& descriptor, const Intervention& what);

/// What was done, as its descriptor words it.
Sentence text_of(const InterventionDescriptor& descriptor, const Intervention& what);

}  // namespace ganglion
