#include "ganglion/link/wire/frames.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ganglion/base/hash.h"

namespace ganglion::link {
namespace {

using Doubles = google::protobuf::RepeatedField<double>;
using Floats = google::protobuf::RepeatedField<float>;

/// Writes the same kind of numbers of every robot, one after the other, as doubles or floats.
template <class Frames, class Numbers>
void write_numbers(const Frames& frames, bool floats, Numbers&& numbers, Doubles& wide, Floats& narrow) {
  const int count = static_cast<int>(frames.size() * numbers(frames.front()).size());
  wide.Resize(floats ? 0 : count, 0);
  narrow.Resize(floats ? count : 0, 0);
  double* to = wide.mutable_data();
  float* to32 = narrow.mutable_data();
  for (const auto& frame : frames) {
    for (const double value : numbers(frame)) {
      if (floats) {
        *to32++ = static_cast<float>(canonical(value));
      } else {
        *to++ = canonical(value);
      }
    }
  }
}

/// Whether there are as many numbers as wanted, in one of the two fields.
bool fits(const Doubles& wide, const Floats& narrow, std::size_t count) noexcept {
  return (wide.size() == static_cast<int>(count) && narrow.empty()) ||
         (wide.empty() && narrow.size() == static_cast<int>(count));
}

/// Numbers of either field, one after the other.
class Numbers {
 public:
  Numbers(const Doubles& wide, const Floats& narrow) noexcept
      : wide_(wide.empty() ? nullptr : wide.data()), narrow_(narrow.empty() ? nullptr : narrow.data()) {}
  bool any() const noexcept { return wide_ != nullptr || narrow_ != nullptr; }
  double next() noexcept { return canonical(wide_ != nullptr ? *wide_++ : static_cast<double>(*narrow_++)); }

 private:
  const double* wide_;
  const float* narrow_;
};

using Words = google::protobuf::RepeatedField<std::uint32_t>;
bool fits(const Words& words, std::size_t count) noexcept {
  return words.empty() || words.size() == static_cast<int>(count);
}

}  // namespace

void write_senses(std::span<const SenseFrame> frames, bool floats, wire::Sense& out) {
  out.set_tick(frames.front().tick);
  out.set_time_s(canonical(frames.front().time_s));
  write_numbers(
      frames, floats, [](const SenseFrame& frame) -> const auto& { return frame.values; }, *out.mutable_values(),
      *out.mutable_values32());
  write_numbers(
      frames, floats, [](const SenseFrame& frame) -> const auto& { return frame.ages_s; }, *out.mutable_ages_s(),
      *out.mutable_ages32_s());
  out.clear_cost_j();
  out.clear_cost32_j();
  const bool known =
      std::any_of(frames.begin(), frames.end(), [](const auto& frame) { return frame.cost.has_value(); });
  for (const SenseFrame& frame : frames) {
    if (!known) break;
    const double cost_J = canonical(frame.cost.value_or(std::numeric_limits<double>::quiet_NaN()));
    if (floats) {
      out.add_cost32_j(static_cast<float>(cost_J));
    } else {
      out.add_cost_j(cost_J);
    }
  }
}

std::uint32_t ttl_ms_of(std::span<const ActFrame> frames) noexcept {
  double longest_s = 0;
  for (const ActFrame& frame : frames) {
    for (const double ttl_s : frame.ttl_s) longest_s = std::max(longest_s, ttl_s);
  }
  return static_cast<std::uint32_t>(std::clamp(std::ceil(longest_s * 1000 - 1e-6), 1.0, 3.6e6));
}

void write_acts(std::span<const ActFrame> frames, bool floats, wire::Act& out) {
  out.set_ttl_ms(ttl_ms_of(frames));
  const double ttl_s = out.ttl_ms() / 1000.0;
  write_numbers(
      frames, floats, [](const ActFrame& frame) -> const auto& { return frame.values; }, *out.mutable_values(),
      *out.mutable_values32());
  bool common = true, plain = true;
  for (const ActFrame& frame : frames) {
    for (std::size_t n = 0; n < frame.ttl_s.size(); ++n) {
      common = common && frame.ttl_s[n] == ttl_s;
      plain = plain && frame.origins[n] == CommandOrigin::Commanded;
    }
  }
  out.clear_ttl_s();
  out.clear_origins();
  out.clear_reasons();
  for (const ActFrame& frame : frames) {
    for (std::size_t n = 0; n < frame.ttl_s.size(); ++n) {
      if (!common) out.add_ttl_s(frame.ttl_s[n]);
      if (!plain) out.add_origins(static_cast<std::uint32_t>(frame.origins[n]));
      if (!plain) out.add_reasons(frame.reasons[n]);
    }
  }
}

double told_time_s(const wire::Sense& message) noexcept {
  return canonical(message.time_ms() != 0 ? message.time_ms() / 1000.0 : message.time_s());
}

bool read_senses(const wire::Sense& message, std::span<SenseFrame> frames) noexcept {
  const std::size_t robots = frames.size(), values = robots * frames.front().values.size();
  Numbers ages(message.ages_s(), message.ages32_s()), costs(message.cost_j(), message.cost32_j());
  if (!fits(message.values(), message.values32(), values)) return false;
  if (ages.any() && !fits(message.ages_s(), message.ages32_s(), robots * frames.front().ages_s.size())) return false;
  if (costs.any() && !fits(message.cost_j(), message.cost32_j(), robots)) return false;
  Numbers numbers(message.values(), message.values32());
  for (SenseFrame& frame : frames) {
    frame.tick = message.tick();
    frame.time_s = told_time_s(message);
    for (double& value : frame.values) value = numbers.next();
    for (double& age_s : frame.ages_s) age_s = ages.any() ? ages.next() : 0;
    frame.cost.reset();
    if (!costs.any()) continue;
    if (const double cost_J = costs.next(); !std::isnan(cost_J)) frame.cost = cost_J;
  }
  return true;
}

bool read_acts(const wire::Act& message, std::span<ActFrame> frames) noexcept {
  const std::size_t commands = frames.size() * frames.front().ttl_s.size();
  if (!fits(message.values(), message.values32(), frames.size() * frames.front().values.size())) return false;
  if (!message.ttl_s().empty() && message.ttl_s_size() != static_cast<int>(commands)) return false;
  if (!fits(message.origins(), commands) || !fits(message.reasons(), commands)) return false;
  const double ttl_s = message.ttl_ms() == 0 ? kDefaultTtl_s : message.ttl_ms() / 1000.0;
  constexpr auto kLast = static_cast<std::uint32_t>(CommandOrigin::Refused);
  Numbers numbers(message.values(), message.values32());
  int at = 0;
  for (ActFrame& frame : frames) {
    frame.tick = message.tick();
    for (double& value : frame.values) value = numbers.next();
    for (std::size_t n = 0; n < frame.ttl_s.size(); ++n, ++at) {
      frame.ttl_s[n] = message.ttl_s().empty() ? ttl_s : message.ttl_s(at);
      const std::uint32_t origin = message.origins().empty() ? 0 : message.origins(at);
      frame.origins[n] = static_cast<CommandOrigin>(std::min(origin, kLast));
      frame.reasons[n] = static_cast<std::uint16_t>(message.reasons().empty() ? 0 : message.reasons(at));
    }
  }
  return true;
}

void make_safe(const Description& description, double max_ttl_s, ActFrame& frame) noexcept {
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

void take_safe_values(const Description& description, ActFrame& frame) noexcept {
  std::size_t n = 0;
  for (std::size_t channel = 0; channel < description.commands.size(); ++channel) {
    for (const CommandElement& element : description.commands[channel].elements) frame.values[n++] = element.safe;
    frame.origins[channel] = CommandOrigin::Safe;
    frame.reasons[channel] = 0;
    frame.ttl_s[channel] = kDefaultTtl_s;
  }
}

}  // namespace ganglion::link
