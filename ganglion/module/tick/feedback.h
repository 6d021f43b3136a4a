#pragma once

#include <limits>
#include <span>

#include "ganglion/module/tick/request.h"
#include "ganglion/module/tick/tick.h"

namespace ganglion {

/// What lies on one input port during a tick. The port of `many` wires has their values one after the other.
struct PortView {
  std::span<const double> values{};
  std::span<const double> ages_s{};  ///< One for each wire: time since it was measured.
  bool wired() const noexcept { return !values.empty(); }
};

/// The input ports of a component, in the order of its descriptor's inputs, whatever their role.
struct Feedback {
  Tick tick{};
  std::span<const PortView> ports{};
  /// What part of the last command was carried out, in [0, 1]: the product of its shares in all commands on its way; 0
  /// where another module overruled it, or a new request broke it off.
  double share = 1;
  /// What became of the last command where it was a request to a module below; None where it went to the application.
  RequestStatus outcome = RequestStatus::None;
  Reason reason{};  ///< Why the module below gave up, when `outcome` is Withdrawn.

  /// All of the last command was carried out, and it alone: what came of it may be learned from.
  bool granted() const noexcept { return share == 1; }

  const PortView& operator[](std::size_t port) const noexcept { return ports[port]; }
  /// First value of a port; NaN where nothing is wired, so that an optional port reads as a dead sensor.
  double value(std::size_t port) const noexcept {
    return ports[port].wired() ? ports[port].values[0] : std::numeric_limits<double>::quiet_NaN();
  }
};

/// What the last command cost, in the application's own unit: of simulated robots energy [J].
struct Cost {
  double value = 0;
};

}  // namespace ganglion
