#pragma once

#include <string>

#include "ganglion/graph/kind_list.h"

namespace ganglion {

/// JSON Schema (2020-12) of controller.toml with these kinds, for editors that complete and check while one types. It
/// knows keys, types, ranges, choices and ports; what wires mean is for read_controller() and resolve().
std::string controller_schema(const KindList& kinds);

}  // namespace ganglion
