#pragma once

#include <string>
#include <string_view>

#include "ganglion/config/value.h"

namespace ganglion::config {

/// Longest line a list is kept on; beyond it stands one item a line [columns].
inline constexpr std::size_t kFormatColumns = 100;

/// The same file in the one layout all our files share. Keeps every comment, the order of keys, the spelling of numbers
/// and strings, and the grouping by blank lines (one at most); `[layout]` goes to the end, so that moving a box in the
/// drawing changes no other line. Formatting twice changes nothing more, and the values are the same: equal().
/// Fails like parse() where the text is not TOML; never gives back a text that would read differently.
Result<std::string> format(std::string_view toml_text, const std::string& file_name);

}  // namespace ganglion::config
