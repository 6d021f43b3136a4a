#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ganglion/record/exhibit/shown.h"

namespace ganglion {

inline constexpr std::string_view kExhibitSchema = "ganglion.Exhibit";
/// The FileDescriptorSet by which other programs decode the messages; goes into the MCAP schema.
std::string exhibit_descriptor();

std::string encode(const shown::Exhibit& exhibit);

/// Most that one message may hold: cells of a layer, layers, everything else that comes in lists.
inline constexpr int kMostCells = 1 << 22;
inline constexpr int kMostLayers = 16;
inline constexpr int kMostListed = 20'000;
inline constexpr int kMostPoints = 100'000;  ///< Of one line or shape, and of all shapes together.

/// None for what is no such message: of a run file any byte may be wrong. What is read keeps every promise of shown.h:
/// sizes fit, scales rise, numbers that a drawing needs are finite, indices are inside.
std::optional<shown::Exhibit> decode_exhibit(std::string_view bytes);

}  // namespace ganglion
