#include "ganglion/record/signals.h"

#include <google/protobuf/descriptor.pb.h>

#include <bit>
#include <cstring>

#include "ganglion/base/expects.h"
#include "ganglion/base/hash.h"
#include "ganglion/record/signals.pb.h"

namespace ganglion {
namespace {

static_assert(std::endian::native == std::endian::little, "protobuf's doubles are little-endian");

char* put_varint(char* at, std::uint64_t value) noexcept {
  for (; value >= 0x80; value >>= 7) *at++ = static_cast<char>(value | 0x80);
  *at++ = static_cast<char>(value);
  return at;
}

char* put_double(char* at, std::uint64_t bits) noexcept {
  std::memcpy(at, &bits, sizeof bits);
  return at + sizeof bits;
}

}  // namespace

void encode_signals(std::uint32_t tick, double time_s, std::span<const double> values, std::string& out) {
  constexpr char kTick = 0x08, kTime = 0x11, kValues = 0x1a;  // field number * 8 + wire type
  constexpr std::size_t kMostHeadBytes = (1 + 5) + (1 + 8) + (1 + 10);
  out.resize(kMostHeadBytes + values.size() * sizeof(double));
  char* at = out.data();
  if (tick != 0) {  // proto3 leaves out what has its default value
    *at++ = kTick;
    at = put_varint(at, tick);
  }
  if (const std::uint64_t time = canonical_bits(time_s); time != 0) {
    *at++ = kTime;
    at = put_double(at, time);
  }
  if (!values.empty()) {
    *at++ = kValues;
    at = put_varint(at, values.size() * sizeof(double));
    for (const double value : values) at = put_double(at, canonical_bits(value));
  }
  out.resize(static_cast<std::size_t>(at - out.data()));
}

bool decode_signals(std::string_view bytes, SignalRow& row) {
  static thread_local Signals message;  // keeps its memory from row to row
  if (bytes.size() > INT32_MAX || !message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return false;
  row.tick = message.tick();
  row.time_s = message.time_s();
  row.values.assign(message.values().begin(), message.values().end());
  return true;
}

std::string signals_descriptor() {
  google::protobuf::FileDescriptorSet set;
  Signals::descriptor()->file()->CopyTo(set.add_file());
  std::string bytes;
  expects(set.SerializeToString(&bytes));
  return bytes;
}

}  // namespace ganglion
