#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"

namespace ganglion {

/// A piece of what one component has learned, as it lies in the store. Component and name together are its key.
struct StoredPart {
  std::string component;      ///< Id in the controller: "router".
  std::string kind;           ///< "DynamicMapRouter": another kind under the same id starts afresh.
  std::uint32_t version = 0;  ///< Of the bytes' layout, which only the kind understands.
  std::string name;           ///< "tile 3".
  std::vector<std::byte> bytes;
  friend bool operator==(const StoredPart&, const StoredPart&) = default;
};

/// All parts of one controller together; files and run attachments beyond this are refused [bytes].
inline constexpr std::size_t kMaxExperienceBytes = std::size_t{1} << 30;

/// One number for all the parts, whatever their order; of a later part with the same key only the later counts.
std::uint64_t snapshot_hash(std::span<const StoredPart> parts);

/// All parts in one string, in the order of their keys and with a checksum: the same parts give the same bytes. For
/// attaching to a run what it started from.
std::string export_parts(std::span<const StoredPart> parts);

/// Reads them back. `name` is the file's in messages. Fails with Corrupt, or Unsupported (a newer program's).
Result<std::vector<StoredPart>> import_parts(std::string_view bytes, const std::string& name);

}  // namespace ganglion
