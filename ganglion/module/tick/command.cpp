#include "ganglion/module/tick/command.h"

#include <algorithm>

#include "ganglion/base/expects.h"

namespace ganglion {

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
