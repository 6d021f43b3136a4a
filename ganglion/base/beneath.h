#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "ganglion/base/file_handle.h"
#include "ganglion/base/result.h"

namespace ganglion {

// Files below a folder, reached part by part and through no link: who puts a link in the way after it was looked at
// leads nobody out. `inner` is relative to `root`, without "." and "..".

/// The folder that holds `inner`; with `make`, missing ones are made, but not the root. Not open where that failed, with
/// errno.
FileHandle folder_beneath(const std::filesystem::path& root, const std::filesystem::path& inner, bool make);

/// The whole text. Fails with NotFound (also where a link is in the way), Unreadable (also for folders, pipes and
/// devices, which it never waits for) or TooLarge.
Result<std::string> read_beneath(const std::filesystem::path& root, const std::filesystem::path& inner,
                                 std::size_t max_bytes);

/// Writes a NewFile in its place. Missing folders are made, the root is not. Fails with NotFound or Unwritable.
Result<void> write_beneath(const std::filesystem::path& root, const std::filesystem::path& inner,
                           std::string_view text);

/// Removes the file if it is there and no folder.
void remove_beneath(const std::filesystem::path& root, const std::filesystem::path& inner);

/// All of a file that was opened without waiting (O_NONBLOCK). Fails with Unreadable (also for folders, pipes and
/// devices) or TooLarge; the place is left to who knows the name.
Result<std::string> read_opened(const FileHandle& file, std::size_t max_bytes);

}  // namespace ganglion
