#include "ganglion/measure/followed.h"

namespace ganglion {
namespace {

constexpr std::array kFollowed = {
    Followed{"travelled_m", "travelled_m", "m", {"way of the body's centre", "camino del centro"}},
    Followed{"energy_J", "energy_J", "J", {"energy taken", "energía consumida"}},
};

}  // namespace

extern constinit const MeasureKind travel_kind{
    .descriptor = {.component_class = ComponentClass::Measure,
                   .name = "Travel",
                   .summary = {"Way and energy: travelled_m, energy_J", "Camino y energía: travelled_m, energy_J"},
                   .source = "ours"},
    .order = 1,
    .figures = [](const MeasureScope& scope) { return followed_figures(scope, kFollowed); },
    .make = [](const MeasureScope& scope) { return make_followed(scope, kFollowed); }};

}  // namespace ganglion
