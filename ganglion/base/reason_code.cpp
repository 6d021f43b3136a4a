#include "ganglion/base/reason_code.h"

namespace ganglion {

std::string_view name_of(ReasonCode code) noexcept {
  switch (code) {
    case ReasonCode::None:
      return "none";
    case ReasonCode::Unreachable:
      return "unreachable";
    case ReasonCode::Trapped:
      return "trapped";
    case ReasonCode::OutsideMap:
      return "outside_map";
    case ReasonCode::BadRequest:
      return "bad_request";
    case ReasonCode::NoReading:
      return "no_reading";
    case ReasonCode::AttemptsExhausted:
      return "attempts_exhausted";
    case ReasonCode::Preempted:
      return "preempted";
  }
  return is_own(code) ? "own" : "?";
}

}  // namespace ganglion
