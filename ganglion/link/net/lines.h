#pragma once

#include <memory>

#include "ganglion/link/controller/line.h"
#include "ganglion/link/net/address.h"

namespace ganglion::link {

/// A line to that address, not yet connected: TCP without delay, or a serial line as raw bytes.
std::unique_ptr<Line> make_line(const Address& address);

/// Seconds of the steady clock.
double steady_s() noexcept;

}  // namespace ganglion::link
