#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "ganglion/base/result.h"

namespace ganglion::config {

/// Just past the string of any of TOML's four forms that opens at `at`; the end of the text where it is not closed.
std::size_t string_end(std::string_view text, std::size_t at) noexcept;

/// Just past the comment that opens at `at`: at its line feed, or at the end of the text.
std::size_t comment_end(std::string_view text, std::size_t at) noexcept;

/// Fails with TooLarge where keys, lists and tables lie in each other deeper than `limit`. Looked at before the text is
/// parsed, because the parser takes stack for every level: a line of a million dots would end the program.
Result<void> check_nesting(std::string_view text, const std::string& file_name, int limit);

}  // namespace ganglion::config
