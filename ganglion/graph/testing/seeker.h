#pragma once

#include "ganglion/module/acting_module.h"

namespace ganglion::testing {

extern const ActingModuleKind seeker_kind, turner_kind, walker_kind;

}  // namespace ganglion::testing
