#pragma once

#include <cstdint>
#include <string_view>

namespace ganglion {

/// Why a module gave up: one of these, which modules above may rely on, or from kFirstOwnReason on the index of a reason
/// of the module's own kind.
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

inline constexpr std::uint16_t kFirstOwnReason = 32;

/// The n-th of a kind's own reasons.
constexpr ReasonCode own_reason(std::uint16_t n) noexcept { return static_cast<ReasonCode>(kFirstOwnReason + n); }
constexpr bool is_own(ReasonCode code) noexcept { return static_cast<std::uint16_t>(code) >= kFirstOwnReason; }

/// "unreachable", as in files; "own" of a kind's own.
std::string_view name_of(ReasonCode) noexcept;

}  // namespace ganglion
