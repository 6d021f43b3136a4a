#pragma once

#include "ganglion/module/global_goal.h"

namespace ganglion::testing {

extern const GlobalGoalKind wish_kind;

}  // namespace ganglion::testing
