#include "ganglion/record/signals.h"

#include <google/protobuf/descriptor.pb.h>

#include <algorithm>

#include "ganglion/base/expects.h"
#include "ganglion/base/hash.h"
#include "ganglion/record/signals.pb.h"

namespace ganglion {
namespace {

/// Keeps its memory from row to row.
Signals& scratch() {
  static thread_local Signals message;
  return message;
}

}  // namespace

void encode_signals(std::uint32_t tick, double time_s, std::span<const double> values, std::string& out) {
  Signals& message = scratch();
  message.set_tick(tick);
  message.set_time_s(canonical(time_s));
  auto& list = *message.mutable_values();
  list.Resize(static_cast<int>(values.size()), 0);
  std::transform(values.begin(), values.end(), list.begin(), canonical);
  expects(message.SerializeToString(&out));
}

bool decode_signals(std::string_view bytes, SignalRow& row) {
  Signals& message = scratch();
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
