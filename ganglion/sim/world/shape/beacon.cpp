#include "ganglion/sim/world/shape/beacon.h"

#include <algorithm>
#include <cmath>

namespace ganglion::sim {
namespace {

constexpr double kTolerance_s = 1e-9;  // times of steps are products and differ from sums by rounding

}  // namespace

Beacon::Chirp Beacon::last_chirp(double time_s) const noexcept {
  if (word.empty() || !(time_s >= start_s - kTolerance_s)) return {};
  const double round_s = static_cast<double>(word.size()) * event_s + pause_s;
  const double since_s = time_s - start_s + kTolerance_s;
  const double round_began_s = std::floor(since_s / round_s) * round_s;
  const auto place = std::min(static_cast<std::size_t>((since_s - round_began_s) / event_s), word.size() - 1);
  return {word[place], start_s + round_began_s + static_cast<double>(place) * event_s};
}

}  // namespace ganglion::sim
