#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ganglion {

/// One message ganglion.Signals (signals.proto).
struct SignalRow {
  std::uint32_t tick = 0;
  double time_s = 0;
  std::vector<double> values;
};

/// Replaces `out` by the message's bytes. Every NaN is written as the one quiet NaN and -0 as 0, so that equal runs
/// have equal bytes. Takes no memory once `out` has grown.
void encode_signals(std::uint32_t tick, double time_s, std::span<const double> values, std::string& out);

/// False when the bytes are no such message. Reuses the memory of `row`.
bool decode_signals(std::string_view bytes, SignalRow& row);

/// The FileDescriptorSet by which other programs decode the messages; goes into the MCAP schema.
std::string signals_descriptor();

inline constexpr std::string_view kSignalsSchema = "ganglion.Signals";

}  // namespace ganglion
