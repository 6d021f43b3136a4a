#pragma once

#include <vector>

#include "ganglion/studio/api/programs.h"
#include "ganglion/studio/api/router.h"

namespace ganglion::studio {

/// What there is to choose from, whatever the folder holds: the kinds of components, and the programs that the user
/// allows, which must outlive the router.
void add_choice_routes(Router& router, const std::vector<AllowedProgram>& programs);

}  // namespace ganglion::studio
