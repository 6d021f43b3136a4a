#include <algorithm>
#include <limits>

#include "ganglion/measure/dwell/longest_stay.h"
#include "ganglion/measure/place.h"

namespace ganglion {
namespace {

constexpr double kStill_mps = 0.005;

/// How long a robot is trapped: the longest time within some disc of 0.5 m, standing on purpose excused.
class Dwell final : public Measure {
 public:
  Dwell(const PlaceColumns& place, std::size_t travelled, std::vector<std::size_t> excuses)
      : place_(place), travelled_(travelled), excuses_(std::move(excuses)) {}

  void update(const Moment& now) override {
    if (now.truth.empty()) return;
    known_ = true;
    const bool excused =
        std::any_of(excuses_.begin(), excuses_.end(), [&](std::size_t i) { return now.signals[i] == 1; });
    const double way_m = now.truth[travelled_] - last_travelled_m_;
    last_travelled_m_ = now.truth[travelled_];
    if (excused && way_m < kStill_mps * now.step_s) {
      stay_.interrupt();
    } else {
      stay_.add(now.time_s, place_.position(now.truth));
    }
  }
  void report(std::span<double> figures) const override {
    figures[0] = known_ ? stay_.longest_s() : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  PlaceColumns place_;
  std::size_t travelled_;
  std::vector<std::size_t> excuses_;  // signals that allow standing still
  LongestStay stay_{0.5, 1};
  double last_travelled_m_ = 0;
  bool known_ = false;
};

}  // namespace

extern constinit const MeasureKind dwell_kind{
    .descriptor = {.component_class = ComponentClass::Measure,
                   .name = "Dwell",
                   .summary = {"Longest time within some disc of 0.5 m, standing on purpose excused: dwell_s",
                               "Mayor tiempo dentro de un disco de 0,5 m, salvo parado a propósito: dwell_s"},
                   .source = "ours"},
    .order = 4,
    .figures = [](const MeasureScope& scope) -> std::vector<Figure> {
      if (!PlaceColumns::in(scope) || !scope.truth_index("travelled_m")) return {};
      return {{.name = "dwell_s",
               .unit = "s",
               .title = say({"longest time within some disc of 0.5 m; not while it stands on purpose",
                             "mayor tiempo dentro de un disco de 0,5 m; no mientras se para a propósito"})}};
    },
    .make = [](const MeasureScope& scope) -> std::unique_ptr<Measure> {
      std::vector<std::size_t> excuses;
      for (std::size_t i = 0; i < scope.signals.size(); ++i) {
        if (scope.signals[i].meaning == Meaning::StandsOnPurpose) excuses.push_back(i);
      }
      return std::make_unique<Dwell>(*PlaceColumns::in(scope), *scope.truth_index("travelled_m"), std::move(excuses));
    }};

}  // namespace ganglion
