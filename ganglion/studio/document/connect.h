#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ganglion/studio/document/drawing.h"

namespace ganglion::studio {

/// Whether a wire may be drawn, and if not, why: the problems that the checks would then report and do not now.
struct Connection {
  std::string component;
  std::string port;
  std::string from;
  std::vector<Sentence> reasons;  ///< Empty: it may.
};

/// One wire, from a source as a wire's text says it ("escape.active@previous") to a port. A list gets one more, a
/// single input another source.
Connection may_connect(const Drawing& drawing, const std::string& from, const std::string& component,
                       const std::string& port);

/// Every input of every component, for one source.
std::vector<Connection> targets_of(const Drawing& drawing, const std::string& from);

/// Every source there is, for one input.
std::vector<Connection> sources_for(const Drawing& drawing, const std::string& component, const std::string& port);

}  // namespace ganglion::studio
