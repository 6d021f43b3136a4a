#pragma once

#include <string>
#include <string_view>

#include "ganglion/config/source/source_map.h"
#include "ganglion/config/value.h"

namespace ganglion::config {

/// Reads what can be read of a TOML text: lines that are no TOML are reported, each at its place, and passed over; all
/// else keeps its place. Of a text without mistakes the same as parse().
Value parse_tolerantly(std::string_view text, const SourceMap& map, const std::string& file_name, Problems& problems);

}  // namespace ganglion::config
