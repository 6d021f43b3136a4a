#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "ganglion/module/command.h"

namespace ganglion {

enum class RequestStatus : std::uint8_t { None, Pending, Satisfied, Withdrawn };

/// A request as a module sees it during a cycle.
struct Request {
  std::span<const double> values{};  ///< Empty when nothing is asked.
  bool fresh = false;                ///< First cycle with this request.
  bool present() const noexcept { return !values.empty(); }
};

/// Where a goal or an upper module leaves a request and finds what became of it. Latched: the values change only once
/// the request is satisfied or withdrawn, or when its holder replaces it.
struct RequestSlot {
  RequestStatus status = RequestStatus::None;
  std::array<double, kMaxCommandValues> values{};
  int size = 0;
  std::uint32_t serial = 0;  ///< Counts the requests made.
  Reason reason{};           ///< Of a withdrawal.
  double cost = 0;           ///< Sum over the ticks since the request was made [J].
  bool has_cost = false;
  std::uint32_t ticks = 0;  ///< Ticks since the request was made.
  int width = 0;            ///< Values that a request must have; 0 = any number of them.

  /// Makes a new request. One that is not of the width or not all numbers is withdrawn on the spot, as BadRequest: no
  /// module ever sees it.
  void ask(std::span<const double> wanted) noexcept;
  /// Nothing is asked any more.
  void clear() noexcept;
  /// The module gives up, or the one above that asked does.
  void withdraw(const Reason& why) noexcept;
  std::span<const double> span() const noexcept { return {values.data(), static_cast<std::size_t>(size)}; }
  std::optional<double> total_cost() const noexcept { return has_cost ? std::optional<double>(cost) : std::nullopt; }
};

/// Whether a reading equals a request, element by element, within a tolerance; angles compare round the turn.
/// A missing reading equals nothing.
bool equal_within(std::span<const double> reading, std::span<const double> request, double tolerance,
                  bool circular) noexcept;

}  // namespace ganglion
