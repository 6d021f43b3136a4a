#pragma once

#include <filesystem>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/plot/view/language.h"
#include "ganglion/plot/view/run_view.h"

namespace ganglion::plot {

/// Draws every picture of a run as SVG, PNG and PDF into `folder`, which is made where it is missing; of `only` the kinds
/// of these names where it has any. The files written. Fails with TooLarge or Unreadable.
Result<std::vector<std::filesystem::path>> draw_all(const RunView& run, const std::filesystem::path& folder,
                                                    Language language, std::span<const std::string> only = {});

}  // namespace ganglion::plot
