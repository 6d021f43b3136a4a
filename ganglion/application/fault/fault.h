#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/application/description.h"
#include "ganglion/base/result.h"

namespace ganglion {

/// What goes wrong between an application and its controller. All are ours.
enum class FaultKind : std::uint8_t {
  Dead,     ///< A sensation reads as its broken device does (NaN, or what the description says); a command is safe.
  Stuck,    ///< Keeps the value it had when the fault began.
  Biased,   ///< `amount` is added, in the signal's unit; angles stay wrapped, readings within their limits.
  Noisy,    ///< A normal deviate of deviation `amount` is added, a new one each tick.
  Late,     ///< Arrives `amount` seconds late (whole ticks); nothing arrives before that.
  Swapped,  ///< Changes places with the signals of `with`.
  Weak,     ///< Of commands: loses the share `amount` of its value.
  Lost,     ///< Each tick with probability `amount` nothing new arrives: ages grow, times to live run out.
};
inline constexpr std::array<std::string_view, 8> kFaultNames = {"dead", "stuck",   "biased", "noisy",
                                                                "late", "swapped", "weak",   "lost"};

/// More faults than this are refused.
inline constexpr std::size_t kMaxFaults = 64;

/// One fault of one or more signals, from when to when.
struct Fault {
  std::string target;  ///< A device ("sonar_left"), a channel ("sonar_left.range"), a command ("drive"), one of its
                       ///< elements ("drive.left"), all sensations ("frames") or all commands ("commands").
  FaultKind kind = FaultKind::Dead;
  double amount = 0;
  std::string with;  ///< The other target of Swapped.
  double from_s = 0;
  double from_latest_s = 0;  ///< Where it is greater than from_s, the fault begins at a time drawn between the two.
  double to_s = std::numeric_limits<double>::infinity();
  double chance = 1;  ///< Probability, by seed and robot, that it happens at all.
  Place place{};      ///< Where it was written.
  /// "sonar_left dead", "compass biased 0.35".
  std::string text() const;
};

/// The signals a fault acts on: positions in the values of a frame, and of their channels.
struct FaultSite {
  bool commands = false;
  std::vector<std::size_t> values;
  std::vector<std::size_t> channels;
  std::vector<std::size_t> with_values;  ///< As many as `values`, for Swapped.
};

/// Fails with UnknownKey where a target names nothing, BadParameter where the amount makes no sense for the kind or the
/// two targets of a swap differ in shape, each with the fault's place.
Result<FaultSite> site_of(const Fault& fault, const Description& robot);

}  // namespace ganglion
