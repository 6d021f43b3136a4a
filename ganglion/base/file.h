#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "ganglion/base/result.h"

namespace ganglion {

/// Largest file read whole unless a caller says otherwise [bytes].
inline constexpr std::size_t kMaxFileBytes = std::size_t{256} << 20;

/// The whole content. Fails with NotFound, Unreadable (also for folders and devices) or TooLarge.
Result<std::string> read_file(const std::filesystem::path& path, std::size_t max_bytes = kMaxFileBytes);

/// What is told of a file over the limit of whoever reads it.
tl::unexpected<Error> too_large(const std::filesystem::path& path, std::size_t bytes, std::size_t most_bytes);

/// Writes beside the file and renames, so that a reader sees the old content or the new, never a part.
/// Missing parent folders are made. Fails with Unwritable.
Result<void> write_file(const std::filesystem::path& path, std::string_view content);

}  // namespace ganglion
