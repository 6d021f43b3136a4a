#pragma once

#include <limits>
#include <span>

#include "ganglion/module/request.h"
#include "ganglion/module/tick.h"

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
  /// Whether the last command was carried out: neither overruled by another module nor broken off by a new request.
  bool granted = true;
  /// What became of the last command where it was a request to a module below; None where it went to the application.
  RequestStatus outcome = RequestStatus::None;
  Reason reason{};  ///< Why the module below gave up, when `outcome` is Withdrawn.

  const PortView& operator[](std::size_t port) const noexcept { return ports[port]; }
  /// First value of a port; NaN where nothing is wired, so that an optional port reads as a dead sensor.
  double value(std::size_t port) const noexcept {
    return ports[port].wired() ? ports[port].values[0] : std::numeric_limits<double>::quiet_NaN();
  }
};

/// Energy the last command took [J].
struct Cost {
  double value = 0;
};

}  // namespace ganglion
