#include "ganglion/link/wire/frames.h"

#include <algorithm>
#include <cmath>

#include "ganglion/base/hash.h"

namespace ganglion::link {
namespace {

using Doubles = google::protobuf::RepeatedField<double>;
using Floats = google::protobuf::RepeatedField<float>;

void write_numbers(std::span<const double> values, bool floats, Doubles& wide, Floats& narrow) {
  const int count = static_cast<int>(values.size());
  wide.Resize(floats ? 0 : count, 0);
  narrow.Resize(floats ? count : 0, 0);
  for (int n = 0; n < count; ++n) {
    const double value = canonical(values[static_cast<std::size_t>(n)]);
    if (floats) {
      narrow.Set(n, static_cast<float>(value));
    } else {
      wide.Set(n, value);
    }
  }
}

/// Whether there are as many numbers as wanted, in one of the two fields.
bool fits(const Doubles& wide, const Floats& narrow, std::size_t count) noexcept {
  return (wide.size() == static_cast<int>(count) && narrow.empty()) ||
         (wide.empty() && narrow.size() == static_cast<int>(count));
}

void read_numbers(const Doubles& wide, const Floats& narrow, std::span<double> into) noexcept {
  for (std::size_t n = 0; n < into.size(); ++n) {
    const int at = static_cast<int>(n);
    into[n] = canonical(wide.empty() ? static_cast<double>(narrow.Get(at)) : wide.Get(at));
  }
}

}  // namespace

void write_sense(const SenseFrame& frame, bool floats, wire::RobotSense& out) {
  write_numbers(frame.values, floats, *out.mutable_values(), *out.mutable_values32());
  write_numbers(frame.ages_s, floats, *out.mutable_ages_s(), *out.mutable_ages32_s());
  out.clear_cost_j();
  out.clear_cost32_j();
  if (frame.cost && !floats) out.set_cost_j(canonical(*frame.cost));
  if (frame.cost && floats) out.set_cost32_j(static_cast<float>(*frame.cost));
}

std::uint32_t ttl_ms_of(std::span<const ActFrame> frames) noexcept {
  double longest_s = 0;
  for (const ActFrame& frame : frames) {
    for (const double ttl_s : frame.ttl_s) longest_s = std::max(longest_s, ttl_s);
  }
  return static_cast<std::uint32_t>(std::clamp(std::ceil(longest_s * 1000 - 1e-6), 1.0, 3.6e6));
}

void write_act(const ActFrame& frame, std::uint32_t ttl_ms, bool floats, wire::RobotAct& out) {
  write_numbers(frame.values, floats, *out.mutable_values(), *out.mutable_values32());
  const int channels = static_cast<int>(frame.ttl_s.size());
  const bool common =
      std::all_of(frame.ttl_s.begin(), frame.ttl_s.end(), [ttl_ms](double ttl_s) { return ttl_s == ttl_ms / 1000.0; });
  out.mutable_ttl_s()->Resize(common ? 0 : channels, 0);
  if (!common) std::copy(frame.ttl_s.begin(), frame.ttl_s.end(), out.mutable_ttl_s()->begin());
  const bool plain = std::all_of(frame.origins.begin(), frame.origins.end(),
                                 [](CommandOrigin origin) { return origin == CommandOrigin::Commanded; });
  out.mutable_origins()->Resize(plain ? 0 : channels, 0);
  out.mutable_reasons()->Resize(plain ? 0 : channels, 0);
  for (int n = 0; n < channels && !plain; ++n) {
    out.set_origins(n, static_cast<std::uint32_t>(frame.origins[static_cast<std::size_t>(n)]));
    out.set_reasons(n, frame.reasons[static_cast<std::size_t>(n)]);
  }
}

bool read_sense(const wire::RobotSense& message, SenseFrame& frame) noexcept {
  const bool ages = !message.ages_s().empty() || !message.ages32_s().empty();
  if (!fits(message.values(), message.values32(), frame.values.size())) return false;
  if (ages && !fits(message.ages_s(), message.ages32_s(), frame.ages_s.size())) return false;
  read_numbers(message.values(), message.values32(), frame.values);
  std::fill(frame.ages_s.begin(), frame.ages_s.end(), 0.0);
  if (ages) read_numbers(message.ages_s(), message.ages32_s(), frame.ages_s);
  frame.cost.reset();
  if (message.has_cost_j()) frame.cost = canonical(message.cost_j());
  if (message.has_cost32_j()) frame.cost = canonical(static_cast<double>(message.cost32_j()));
  return true;
}

bool read_act(const wire::RobotAct& message, double ttl_s, ActFrame& frame) noexcept {
  const int channels = static_cast<int>(frame.ttl_s.size());
  if (!fits(message.values(), message.values32(), frame.values.size())) return false;
  if (!message.ttl_s().empty() && message.ttl_s_size() != channels) return false;
  if (!message.origins().empty() && message.origins_size() != channels) return false;
  if (!message.reasons().empty() && message.reasons_size() != channels) return false;
  read_numbers(message.values(), message.values32(), frame.values);
  for (int n = 0; n < channels; ++n) {
    const auto at = static_cast<std::size_t>(n);
    frame.ttl_s[at] = message.ttl_s().empty() ? ttl_s : message.ttl_s(n);
    const std::uint32_t origin = message.origins().empty() ? 0 : message.origins(n);
    frame.origins[at] =
        static_cast<CommandOrigin>(std::min(origin, static_cast<std::uint32_t>(CommandOrigin::Refused)));
    frame.reasons[at] = static_cast<std::uint16_t>(message.reasons().empty() ? 0 : message.reasons(n));
  }
  return true;
}

void make_safe(const RobotDescription& description, double max_ttl_s, ActFrame& frame) noexcept {
  std::size_t n = 0;
  for (std::size_t channel = 0; channel < description.commands.size(); ++channel) {
    frame.ttl_s[channel] = frame.ttl_s[channel] > 0 ? std::min(frame.ttl_s[channel], max_ttl_s) : 0;
    for (const CommandElement& element : description.commands[channel].elements) {
      double& value = frame.values[n++];
      if (!std::isfinite(value)) {
        value = element.safe;
        frame.origins[channel] = CommandOrigin::Refused;
      }
      value = std::clamp(value, element.min, element.max);
    }
  }
}

void take_safe_values(const RobotDescription& description, ActFrame& frame) noexcept {
  std::size_t n = 0;
  for (std::size_t channel = 0; channel < description.commands.size(); ++channel) {
    for (const CommandElement& element : description.commands[channel].elements) frame.values[n++] = element.safe;
    frame.origins[channel] = CommandOrigin::Safe;
    frame.reasons[channel] = 0;
    frame.ttl_s[channel] = kDefaultTtl_s;
  }
}

}  // namespace ganglion::link
