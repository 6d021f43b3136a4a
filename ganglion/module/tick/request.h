#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "ganglion/module/tick/command.h"

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
  std::uint32_t serial = 0;     ///< Counts the requests made.
  std::uint32_t concluded = 0;  ///< Counts those that were satisfied or withdrawn.
  Reason reason{};              ///< Of a withdrawal.
  double cost = 0;              ///< Sum over the ticks since the request was made; of a standing one of the last tick.
  bool has_cost = false;
  std::uint32_t ticks = 0;  ///< Ticks since the request was made.
  bool lost = false;        ///< It was satisfied, and what is read now differs from it again.
  int width = 0;            ///< Values that a request must have; 0 = any number of them.
  /// A set-point: never satisfied, replaced whenever other values are asked; nobody above waits for it.
  bool standing = false;
  double ttl_s = std::numeric_limits<double>::infinity();  ///< Of a standing one: what is done for it lapses then.

  /// Makes a new request. One that is not of the width or not all numbers is withdrawn on the spot, as BadRequest: no
  /// module ever sees it.
  void ask(std::span<const double> wanted) noexcept;
  /// What a command or a bid of the present tick asks. A standing request, and any that a coordinator passes on, is
  /// made anew only where the values differ or it has ended.
  void keep_asking(std::span<const double> wanted, double for_s) noexcept;
  /// Nothing is asked any more.
  void clear() noexcept;
  /// The module gives up, or the one above that asked does.
  void withdraw(const Reason& why) noexcept;
  std::span<const double> span() const noexcept { return {values.data(), static_cast<std::size_t>(size)}; }
  std::optional<double> total_cost() const noexcept { return has_cost ? std::optional<double>(cost) : std::nullopt; }
};

/// How a reading is held against what is sought, element by element.
struct Comparison {
  std::array<double, kMaxCommandValues> tolerance{};
  std::array<bool, kMaxCommandValues> circular{};  ///< Angles: differences go round the turn.

  static Comparison within(double tolerance, bool circular = false) noexcept {
    Comparison all;
    all.tolerance.fill(tolerance);
    all.circular.fill(circular);
    return all;
  }
};

/// Whether a reading equals what is sought. A missing reading equals nothing.
bool equal_within(std::span<const double> reading, std::span<const double> sought, const Comparison& how) noexcept;

/// What the first Feedback port of a module must equal for its request to be satisfied.
struct Sought {
  std::array<double, kMaxCommandValues> values{};
  int size = 0;
  void set(std::span<const double> wanted) noexcept;
  std::span<const double> span() const noexcept { return {values.data(), static_cast<std::size_t>(size)}; }
};

}  // namespace ganglion
