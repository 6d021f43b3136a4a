#pragma once

#include <span>
#include <string>

#include "ganglion/descriptor/descriptor.h"

namespace ganglion {

/// What the studio's palette and forms and `ganglion kinds --json` need of kinds: a JSON list, in the order given. Of
/// each: class, name, paper_name, summary and help in both languages, source; ports with role, direction, unit, type,
/// size, elements, required, many, title, and `common` where every component of the class has them; `standing`,
/// `each_candidate` and `derived` where they are; parameters with type, unit, default, min and max (absent = without
/// limit), allowed, choices, count, ours, live, title, common.
std::string kinds_json(std::span<const Descriptor* const> kinds);

}  // namespace ganglion
