#include <algorithm>
#include <cmath>
#include <limits>

#include "ganglion/measure/place.h"

namespace ganglion {
namespace {

/// Ahead of a wall a robot cannot be asked to come closer than its behaviours avoid (0.40 m) and a little.
constexpr double kFarWallMargin_m = 0.5;

/// How far a robot comes along the heading it starts with, against the same run on free ground.
class Course final : public Measure {
 public:
  Course(const PlaceColumns& place, const Terrain* terrain, double radius_m)
      : place_(place), terrain_(terrain), radius_m_(radius_m) {}

  void begin(const Moment& start, const Unhindered* unhindered) override {
    known_ = !start.truth.empty();
    if (!known_) return;
    start_ = last_ = place_.position(start.truth);
    course_ = direction(start.truth[place_.yaw]);
    far_wall_m_ = terrain_ != nullptr ? terrain_->far_wall_m(start_, course_) : std::numeric_limits<double>::infinity();
    reach_m_ = far_wall_m_ - radius_m_ - kFarWallMargin_m;
    at_far_wall_ = reach_m_ <= 0;
    for (std::size_t n = 0; unhindered != nullptr && n < unhindered->rows(); ++n) {
      const double along_m = (place_.position(unhindered->row(n)) - start_).dot(course_);
      free_.push_back(std::max(along_m, n > 0 ? free_.back() : 0));
    }
  }

  void update(const Moment& now) override {
    ++ticks_;
    if (now.truth.empty()) return;
    last_ = place_.position(now.truth);
    progress_m_ = std::max(progress_m_, (last_ - start_).dot(course_));
    if (at_far_wall_ || free_.empty()) return;
    const double ideal_m = std::min(free_[std::min(ticks_, free_.size()) - 1], reach_m_);
    progress_ratio_ = ideal_m > 0 ? std::min(progress_m_, reach_m_) / ideal_m : 1;
    at_far_wall_ = progress_m_ >= reach_m_;
    if (at_far_wall_) {  // what the way took, against what it would have taken on free ground
      const auto arrival = std::lower_bound(free_.begin(), free_.end(), reach_m_);
      progress_ratio_ = static_cast<double>(arrival - free_.begin() + 1) / static_cast<double>(ticks_);
    }
  }

  void report(std::span<double> figures) const override {
    if (!known_) {
      std::fill(figures.begin(), figures.end(), std::numeric_limits<double>::quiet_NaN());
      return;
    }
    const Vector2 way = last_ - start_;
    figures[0] = progress_m_;
    figures[1] = far_wall_m_;
    figures[2] = std::fabs(course_.x * way.y - course_.y * way.x);
    figures[3] = at_far_wall_ ? 1 : 0;
    figures[4] = free_.empty() ? std::numeric_limits<double>::quiet_NaN() : progress_ratio_;
  }

 private:
  PlaceColumns place_;
  const Terrain* terrain_;
  double radius_m_;
  bool known_ = false;
  Vector2 start_{}, course_{}, last_{};
  double far_wall_m_ = 0;
  double reach_m_ = 0;        // progress at which the far wall counts as reached
  std::vector<double> free_;  // progress on free ground, tick by tick
  std::size_t ticks_ = 0;
  double progress_m_ = 0;
  double progress_ratio_ = 1;
  bool at_far_wall_ = false;
};

std::vector<Figure> figures_of(const MeasureScope& scope) {
  if (scope.terrain == nullptr || !PlaceColumns::in(scope)) return {};
  return {{.name = "progress_m",
           .unit = "m",
           .title = say({"farthest way along the heading of the start", "mayor avance según el rumbo de salida"})},
          {.name = "far_wall_m",
           .unit = "m",
           .title = say({"way along it up to the first structural wall", "avance posible hasta la primera pared"})},
          {.name = "off_course_m",
           .unit = "m",
           .title = say({"distance from the line along which it started", "distancia a la línea de salida"})},
          {.name = "at_far_wall",
           .unit = "",
           .title = say({"1 once it has come to the far wall", "1 una vez que llegó a la pared del fondo"}),
           .listed = false},
          {.name = "progress_ratio",
           .unit = "",
           .title = say({"progress against that on free ground, until the far wall",
                         "avance frente al de un terreno libre, hasta la pared del fondo"}),
           .sparse = true}};
}

}  // namespace

extern constinit const MeasureKind course_kind{
    .descriptor =
        {.component_class = ComponentClass::Measure,
         .name = "Course",
         .summary = {"Progress along the heading of the start: progress_m, far_wall_m, off_course_m, "
                     "progress_ratio, and at_far_wall for stop rules",
                     "Avance según el rumbo de salida: progress_m, far_wall_m, off_course_m, progress_ratio, y "
                     "at_far_wall para parar"},
         .source = "ours"},
    .order = 3,
    .figures = figures_of,
    .make = [](const MeasureScope& scope) -> std::unique_ptr<Measure> {
      return std::make_unique<Course>(*PlaceColumns::in(scope), scope.terrain, scope.radius_m);
    }};

}  // namespace ganglion
