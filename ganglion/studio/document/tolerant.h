#pragma once

#include <string>
#include <string_view>

#include "ganglion/config/value.h"
#include "ganglion/studio/document/source_map.h"

namespace ganglion::studio {

/// Reads what can be read of a TOML text: lines that are no TOML are reported, each at its place, and passed over; all
/// else keeps its place. Of a text without mistakes the same as config::parse().
config::Value parse_tolerantly(std::string_view text, const SourceMap& map, const std::string& file_name,
                               Problems& problems);

}  // namespace ganglion::studio
