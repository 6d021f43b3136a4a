#include "ganglion/module/command.h"

#include <algorithm>

#include "ganglion/base/expects.h"

namespace ganglion {

std::string_view name_of(ReasonCode code) noexcept {
  switch (code) {
    case ReasonCode::None:
      return "none";
    case ReasonCode::Unreachable:
      return "unreachable";
    case ReasonCode::Trapped:
      return "trapped";
    case ReasonCode::OutsideMap:
      return "outside_map";
    case ReasonCode::BadRequest:
      return "bad_request";
    case ReasonCode::NoReading:
      return "no_reading";
    case ReasonCode::AttemptsExhausted:
      return "attempts_exhausted";
    case ReasonCode::Preempted:
      return "preempted";
  }
  return "?";
}

Command Command::act(std::span<const double> values) noexcept {
  expects(values.size() <= kMaxCommandValues);
  Command command;
  command.kind = CommandKind::Act;
  command.size = static_cast<int>(values.size());
  std::copy(values.begin(), values.end(), command.values.begin());
  return command;
}

Command Command::withdraw(Reason reason) noexcept {
  Command command;
  command.kind = CommandKind::Withdraw;
  command.reason = reason;
  return command;
}

}  // namespace ganglion
