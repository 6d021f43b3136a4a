#pragma once

#include <span>
#include <string>
#include <vector>

#include "ganglion/plot/picture/picture_kind.h"

namespace ganglion::plot {

/// Every kind of picture, in their order; the list is written by the build from the folders that hold one.
std::vector<const PictureKind*> picture_kinds();

/// What there is to see of a run, in the order of the kinds; of `only` the kinds of these names where it has any. Each
/// keeps a pointer to the run, which must outlive it.
std::vector<Picture> all_pictures(const RunView& run, Language language, std::span<const std::string> only = {});

}  // namespace ganglion::plot
