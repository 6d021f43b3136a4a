#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

namespace ganglion {

/// Why a module gave up. Words for people in both languages: describe().
enum class ReasonCode : std::uint16_t {
  None = 0,
  Unreachable,        ///< No route is left, every one was tried. Arguments: tries, rounds.
  Trapped,            ///< Cannot move in any direction. Arguments: column, row.
  OutsideMap,         ///< The request lies beyond what the module may remember. Arguments: column, row.
  BadRequest,         ///< The request is not a number or not of the kind. Arguments: the first two values.
  NoReading,          ///< A required sensation has been silent for too long. Arguments: port, seconds.
  AttemptsExhausted,  ///< Every way of doing the step failed. Arguments: attempts, level.
  Preempted,          ///< A goal of a higher class took the module. Arguments: the goals' indices.
};

struct Reason {
  ReasonCode code = ReasonCode::None;
  double first = 0;
  double second = 0;
};

/// "unreachable: no route is left after 3 rounds", in English or Spanish.
std::string_view name_of(ReasonCode) noexcept;

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
