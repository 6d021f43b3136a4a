#pragma once

#include <deque>

#include "ganglion/geometry/vector2.h"

namespace ganglion {

/// Longest time that a robot stayed within some disc of a given radius: the measure of being trapped. The disc may lie
/// anywhere: for each stretch of time it is the smallest one round all positions of that stretch.
class LongestStay {
 public:
  /// Positions are looked at every `sample_s`.
  LongestStay(double radius_m, double sample_s) : radius_m_(radius_m), sample_s_(sample_s) {}
  void add(double time_s, Vector2 position);
  /// The time of standing still on purpose does not count: the stretch ends here.
  void interrupt() { stretch_.clear(); }
  double longest_s() const noexcept { return longest_s_; }

 private:
  struct Sample {
    double time_s;
    Vector2 position;
  };
  double radius_m_;
  double sample_s_;
  double next_s_ = 0;
  double longest_s_ = 0;
  std::deque<Sample> stretch_;
};

struct Circle {
  Vector2 centre{};
  double radius_m = 0;
};

/// The smallest circle round a set of points. Source: Welzl, "Smallest enclosing disks" (1991), move-free form.
Circle smallest_circle(const std::deque<Vector2>& points);

}  // namespace ganglion
