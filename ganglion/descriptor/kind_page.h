#pragma once

#include <string>

#include "ganglion/descriptor/language.h"

namespace ganglion {

/// The page of the reference manual on a kind, as Markdown: what it does, its ports with roles, units and shapes, its
/// parameters with units, ranges and defaults, each that the source does not give marked as ours, and the source.
std::string kind_page(const Descriptor& kind, Language language);

}  // namespace ganglion
