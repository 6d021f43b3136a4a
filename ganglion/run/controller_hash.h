#pragma once

#include <string>
#include <vector>

#include "ganglion/base/files.h"
#include "ganglion/config/value.h"
#include "ganglion/graph/model.h"

namespace ganglion {

/// Of a controller's text, the files it names, and what --set changed in it; 16 hex digits.
std::string controller_hash(const OpenedFile& file, const ControllerModel& controller,
                            const std::vector<config::Override>& overrides);

}  // namespace ganglion
