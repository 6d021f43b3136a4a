#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/plot/view/language.h"
#include "ganglion/plot/view/run_view.h"

namespace ganglion::report {

struct ReportOptions {
  plot::Language language = plot::Language::English;  ///< The one it opens in; the page can switch to the other.
};

/// One HTML page that opens offline, asks nothing of any network and needs no other file: outcome, measures, an
/// animated player, the pictures, the events. 120 s at 10 Hz take less than 1 MB. Whatever the names in a run say, they
/// stay text. Fails where a picture cannot be drawn.
Result<std::string> report_page(const plot::RunView& run, const ReportOptions& options = {});

/// The same into a file. Fails with Unwritable as well.
Result<void> write_report(const plot::RunView& run, const std::filesystem::path& path,
                          const ReportOptions& options = {});

}  // namespace ganglion::report
