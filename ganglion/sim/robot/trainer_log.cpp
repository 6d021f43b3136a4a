#include "ganglion/sim/robot/trainer_log.h"

#include <array>

namespace ganglion::sim {

std::string_view name_of(GoalOutcome outcome) noexcept {
  constexpr std::array<std::string_view, 5> kNames = {"open", "reached", "withdrawn", "timed_out", "replaced"};
  return kNames[static_cast<std::size_t>(outcome)];
}

}  // namespace ganglion::sim
