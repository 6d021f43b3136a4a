#pragma once

#include <span>
#include <string>

#include "ganglion/base/sentence.h"
#include "ganglion/descriptor/descriptor.h"

namespace ganglion {

/// The page of the reference manual on a kind, as Markdown: what it does, its ports with roles, units and shapes, its
/// parameters with units, ranges and defaults, each that the source does not give marked as ours, and the source.
std::string kind_page(const Descriptor& kind, Language language);

/// The manual's page on `ganglion kinds`, as Markdown: a list of all kinds with links, then the page of each, in the
/// order given, under a heading for each class.
std::string kinds_page(std::span<const Descriptor* const> kinds, Language language);

}  // namespace ganglion
