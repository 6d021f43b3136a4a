#pragma once

#include <cstdint>

#include "ganglion/run/prepared.h"
#include "ganglion/studio/api/ask.h"
#include "ganglion/studio/folder/folder.h"
#include "ganglion/studio/live/run_session.h"

namespace ganglion::studio {

/// How the page wants the prepared run to go, and the file below `runs` that it is recorded in. Fails with BadParameter
/// for a seed or pace that is none, with NotFound where `runs` leads out of the folder.
Result<RunPlan> plan_of(const Ask& ask, const Prepared& prepared, const Folder& folder);

/// Another file for the same run, if it is recorded; `number` is that of the new one.
void renew_file(RunPlan& plan, std::uint64_t number);

}  // namespace ganglion::studio
