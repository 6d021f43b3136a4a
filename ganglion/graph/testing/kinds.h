#pragma once

#include "ganglion/graph/kind_list.h"

namespace ganglion::testing {

/// Small kinds for tests of the graph. What they live through is on their outputs, so tests read signals only.
///
/// Sensing      Gain      out = gain * in.
///              Copy      out = in, of any size and unit.
///              Surprise  error = in - expected, heard = expected (an appraisal).
///              Sum       out = sum of the wires of in.
///              AgeOf     out = age of its input.
///              Noise     out = one uniform draw a tick.
/// Goal         Wish      asks for `values`, or for what is wired to `wish`, while `wanted` (if wired) is above 0.
///                        Outputs count what became of its requests.
/// Acting       Seeker    metres, Turner radians (circular), Walker {column, row} (discrete): commands the next point
///                        on the way to the request, or with relative = true the step to it. Withdraws (Trapped) from
///                        `give_up_at` on. Expects to be at the next point at the next tick. Remembers its steps.
///              Puppet    does as its input `act` says: 0 inactive, 1 act, 2 withdraw; commands `value`.
/// Coordinator  First     the first candidate that acts; generous = true claims a full share for every candidate.
KindList kinds() noexcept;

}  // namespace ganglion::testing
