#pragma once

#include "ganglion/module/sensing_module.h"

namespace ganglion::testing {

extern const SensingModuleKind gain_kind, copy_kind, surprise_kind, sum_kind, age_of_kind, noise_kind;

}  // namespace ganglion::testing
