#pragma once

#include <functional>
#include <memory>
#include <string>

#include "ganglion/link/controller/line.h"

namespace ganglion::link {

/// Looks at a robot without moving it: watches, measures, and says in plain words what it offers and what is wrong.
/// `say` gets whether a finding is good, and the finding. Returns whether all were.
bool examine(std::unique_ptr<Line> line, const std::function<void(bool good, const std::string& finding)>& say);

}  // namespace ganglion::link
