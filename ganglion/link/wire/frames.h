#pragma once

#include "ganglion/application/application.h"
#include "ganglion/link/wire/link.pb.h"

namespace ganglion::link {

/// Time to live of commands that give none [s].
inline constexpr double kDefaultTtl_s = 0.3;

/// Between frames as controllers see them, one for each robot, and messages. Numbers are made canonical on both ways
/// (application.h), and with `floats` rounded to single precision. Nothing is allocated once the messages have their
/// size.
void write_senses(std::span<const SenseFrame> frames, bool floats, wire::Sense& out);
/// Times to live are left out where all are those of the whole Act.
void write_acts(std::span<const ActFrame> frames, bool floats, wire::Act& out);

/// The time to live that holds for a whole Act: the longest of all channels, rounded up [ms]; 1 where all have run out.
std::uint32_t ttl_ms_of(std::span<const ActFrame> frames) noexcept;

/// The robot's clock as a Sense tells it [s]; 0 where it does not.
double told_time_s(const wire::Sense& message) noexcept;

/// Fill frames of the described size, tick and time included. False, and nothing changed, where the message has other
/// sizes.
bool read_senses(const wire::Sense& message, std::span<SenseFrame> frames) noexcept;
bool read_acts(const wire::Act& message, std::span<ActFrame> frames) noexcept;

/// Puts commands within the limits of the robot: what is not finite becomes the safe value (Refused), times to live lie
/// in [0, max_ttl_s].
void make_safe(const Description& description, double max_ttl_s, ActFrame& frame) noexcept;
/// The safe values, as nobody commands any more.
void take_safe_values(const Description& description, ActFrame& frame) noexcept;

}  // namespace ganglion::link
