#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "ganglion/base/reason_code.h"

namespace ganglion {

struct Reason {
  ReasonCode code = ReasonCode::None;
  double first = 0;
  double second = 0;
  /// Of a kind's own reason the common one that it is a case of; filled in as it is sent.
  ReasonCode like = ReasonCode::None;

  /// As who knows nothing of the kind understands it.
  Reason common() const noexcept { return is_own(code) ? Reason{like, first, second} : *this; }
};

enum class CommandKind : std::uint8_t {
  Inactive,  ///< Nothing to command: the next candidate drives, or the safe value is taken.
  Act,       ///< Values are to be carried out.
  Withdraw,  ///< Given up, with a reason; the safe value is taken. A normal outcome, not an error.
};

/// Most values a command may have.
inline constexpr int kMaxCommandValues = 16;

/// What a module wants done until the next tick, or for ttl_s if that is shorter.
struct Command {
  CommandKind kind = CommandKind::Inactive;
  int size = 0;
  std::array<double, kMaxCommandValues> values{};
  double ttl_s = std::numeric_limits<double>::infinity();
  Reason reason{};

  static Command inactive() noexcept { return {}; }
  static Command act(std::span<const double> values) noexcept;
  static Command act(std::initializer_list<double> values) noexcept {
    return act(std::span<const double>(values.begin(), values.size()));
  }
  static Command withdraw(Reason reason) noexcept;
  std::span<const double> span() const noexcept { return {values.data(), static_cast<std::size_t>(size)}; }
};

}  // namespace ganglion
