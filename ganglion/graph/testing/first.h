#pragma once

#include "ganglion/module/coordinator.h"

namespace ganglion::testing {

extern const CoordinatorKind first_kind;

}  // namespace ganglion::testing
