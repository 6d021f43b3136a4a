#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"

namespace ganglion::link {

/// What befalls the frames of a line between a controller and its robot for a while; where several faults act at one
/// time, each does its part. All are ours.
struct LineFault {
  bool to_robot = true, to_controller = true;  ///< Which way. Both where neither was named.
  double from_s = 0;                           ///< From the first connection.
  double until_s = std::numeric_limits<double>::infinity();
  double delay_s = 0;    ///< Every frame takes so long.
  double jitter_s = 0;   ///< And up to so much longer, drawn uniformly; order is kept.
  double loss = 0;       ///< Share of the frames that vanish whole.
  double duplicate = 0;  ///< ... that arrive twice.
  double merge = 0;      ///< ... that arrive in one piece with the next one, or kMergePatience_s late if there is none.
  double split = 0;      ///< ... that arrive in two to four pieces, kSplitGap_s apart.
  double corrupt = 0;    ///< Share of the bytes in which one bit is changed.
  double fin = 0;     ///< Share of the frames within which the connection ends in order: what was sent before arrives.
  double rst = 0;     ///< ... within which it ends at once: what is under way is lost, both ways.
  bool mute = false;  ///< All frames vanish, and nobody is told when the connection ends: one way of it is half-open.
  bool freeze = false;  ///< Nothing arrives until `until_s`; then all of it does.
  friend bool operator==(const LineFault&, const LineFault&) = default;
};
using LineFaults = std::vector<LineFault>;

inline constexpr double kMergePatience_s = 0.05;
inline constexpr double kSplitGap_s = 0.001;

/// Reads faults as people write them: parts between ";", in each of them words and key=value between ",", as in
/// "delay=20ms,jitter=5ms,loss=1%; freeze,from=4s,until=6s; mute,to=robot,from=8s,until=9s". Times have a unit (ms, s,
/// min), shares are numbers from 0 to 1 or have a "%". "" and "none" are no faults. Fails with Syntax, UnknownKey,
/// BadParameter or TooLarge at line 1 and the column, of `name`.
Result<LineFaults> parse_line_faults(std::string_view text, const std::string& name = "--faults");

/// What parse_line_faults() reads back as the same.
std::string text_of(const LineFaults& faults);

/// How hard drawn faults may be.
enum class Hardness : std::uint8_t {
  Mendable,  ///< Nothing that changes what frames say: every session can be brought to its end.
  Any,       ///< Bytes are changed and frames doubled as well.
};
/// One to four faults drawn from a seed. Those that hinder begin within 4 s and last at most 4 s; delays and how bytes
/// are cut may go on for ever.
LineFaults drawn_line_faults(std::uint64_t seed, Hardness hardness);

}  // namespace ganglion::link
