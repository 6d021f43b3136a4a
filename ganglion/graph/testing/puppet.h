#pragma once

#include "ganglion/module/acting_module.h"

namespace ganglion::testing {

extern const ActingModuleKind puppet_kind;

}  // namespace ganglion::testing
