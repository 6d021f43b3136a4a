#pragma once

#include "ganglion/module/sensing_module.h"

namespace ganglion::testing {

/// Has an output for each line of its file, "name factor": the input times the factor. The preset is "out 2".
extern const SensingModuleKind ruled_kind;

}  // namespace ganglion::testing
