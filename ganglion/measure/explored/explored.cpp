#include <cmath>
#include <limits>
#include <unordered_set>

#include "ganglion/measure/place.h"

namespace ganglion {
namespace {

constexpr double kSquare_m = 0.25;

std::uint64_t square_of(Vector2 position) noexcept {
  const auto column = static_cast<std::int32_t>(std::floor(position.x / kSquare_m));
  const auto row = static_cast<std::int32_t>(std::floor(position.y / kSquare_m));
  return (std::uint64_t{static_cast<std::uint32_t>(column)} << 32) | static_cast<std::uint32_t>(row);
}

/// Area of the squares that a robot's centre has been in.
class Explored final : public Measure {
 public:
  explicit Explored(const PlaceColumns& place) : place_(place) {}
  void update(const Moment& now) override {
    if (!now.truth.empty()) visited_.insert(square_of(place_.position(now.truth)));
  }
  void report(std::span<double> figures) const override {
    const bool known = !visited_.empty();
    figures[0] =
        known ? static_cast<double>(visited_.size()) * kSquare_m * kSquare_m : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  PlaceColumns place_;
  std::unordered_set<std::uint64_t> visited_;  // only counted, never walked through
};

}  // namespace

extern constinit const MeasureKind explored_kind{
    .descriptor = {.component_class = ComponentClass::Measure,
                   .name = "Explored",
                   .summary = {"Area of the 0.25 m squares that the centre has been in: explored_m2",
                               "Superficie de los cuadrados de 0,25 m en que estuvo el centro: explored_m2"},
                   .source = "ours"},
    .order = 5,
    .figures = [](const MeasureScope& scope) -> std::vector<Figure> {
      if (!PlaceColumns::in(scope)) return {};
      return {{.name = "explored_m2",
               .unit = "m2",
               .title = say({"area of the 0.25 m squares the centre has been in",
                             "superficie de los cuadrados de 0,25 m en que estuvo el centro"})}};
    },
    .make = [](const MeasureScope& scope) -> std::unique_ptr<Measure> {
      return std::make_unique<Explored>(*PlaceColumns::in(scope));
    }};

}  // namespace ganglion
