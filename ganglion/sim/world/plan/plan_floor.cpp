#include "ganglion/sim/world/plan/plan_floor.h"

#include <algorithm>
#include <charconv>

#include "ganglion/math/functions.h"
#include "ganglion/sim/world/plan/plan_points.h"

namespace ganglion::sim {
namespace {

constexpr config::Range kTime{1e-3, 1e6};

Colour read_colour(config::Table& table, const Colour& preset) {
  const std::string text = table.text("colour", "");
  if (!table.has("colour")) return preset;
  unsigned value = 0;
  const char* end = text.data() + text.size();
  const bool form = text.size() == 7 && text[0] == '#';
  const auto read = std::from_chars(text.data() + (form ? 1 : 0), end, value, 16);
  if (!form || read.ptr != end || read.ec != std::errc()) {
    table.problem("colour", ErrorCode::BadParameter,
                  {"colour is \"{}\", must be \"#rrggbb\", two hexadecimal digits each",
                   "colour es \"{}\", debe ser \"#rrggbb\", con dos cifras hexadecimales por color"},
                  text);
    return preset;
  }
  return {(value >> 16) / 255.0, (value >> 8 & 255) / 255.0, (value & 255) / 255.0};
}

/// Where a zone lies: a polygon, a disc or a box.
void read_outline(config::Table& table, FloorZone& zone) {
  zone.box = empty_box();
  if (table.has("points")) {
    zone.outline = read_points(table, "points", 3);
    if (check_spacing(table, "points", zone.outline, true)) check_outline(table, "points", zone.outline);
    if (doubled_area(zone.outline) < 0) std::reverse(zone.outline.begin(), zone.outline.end());
  } else if (table.has("radius_m")) {
    zone.disc = {read_position(table), table.number("radius_m", kExtent)};
    const Vector2 reach{zone.disc.radius_m, zone.disc.radius_m};
    zone.box = {zone.disc.position - reach, zone.disc.position + reach};
  } else {
    const Vector2 centre = read_position(table);
    const double length_m = table.number("length_m", kExtent), width_m = table.number("width_m", kExtent);
    const double yaw_rad = Angle::from_deg(table.number("yaw_deg", 0, {-360, 360})).rad();
    zone.outline = rectangle(centre, length_m, width_m, yaw_rad);
  }
  for (const Vector2 point : zone.outline) zone.box.include(point);
}

void read_slope(config::Table& table, FloorZone& zone) {
  zone.grade = math::tan(Angle::from_deg(table.number("slope_deg", 0, {0, 80})).rad());
  zone.uphill = direction(Angle::from_deg(table.number("uphill_deg", 0, {-360, 360})).rad());
  zone.height_m = table.number("height_m", 0, {-1000, 1000});
  zone.lowest_m = zone.uphill.dot(zone.disc.position) - zone.disc.radius_m;
  if (zone.outline.empty()) return;
  zone.lowest_m = zone.uphill.dot(zone.outline.front());
  for (const Vector2 point : zone.outline) zone.lowest_m = std::min(zone.lowest_m, zone.uphill.dot(point));
}

void read_zones(config::Table& root, ItemIds& ids, Floor& floor) {
  for (config::Table& table : root.tables("floor")) {
    FloorZone zone;
    zone.id = ids.read(table, false);
    zone.label = table.text("label", "");
    read_outline(table, zone);
    zone.slip = table.number("slip", 0, {0, 1});
    zone.slip_spread = table.number("slip_spread", 0, {0, 1});
    zone.colour = read_colour(table, kPlainFloor);
    zone.warmer_C = table.number("warmer_C", 0, {-100, 100});
    read_slope(table, zone);
    floor.zones.push_back(std::move(zone));
  }
}

void read_bumps(config::Table& root, ItemIds& ids, Floor& floor) {
  for (config::Table& table : root.tables("bump")) {
    const std::string id = ids.read(table, false);
    const double turn_rad = Angle::from_deg(table.number("turn_deg", 5, {0, 90})).rad();
    const auto points = read_points(table, "points", 2);
    check_spacing(table, "points", points, false);
    for (std::size_t n = 1; n < points.size(); ++n) floor.bumps.push_back({id, points[n - 1], points[n], turn_rad});
  }
}

void read_word(config::Table& table, Beacon& beacon) {
  const auto events = table.numbers("word", {}, 0, {1, 255});
  for (const double event : events) beacon.word.push_back(static_cast<int>(std::clamp(event, 0.0, 255.0)));
  if (!std::equal(events.begin(), events.end(), beacon.word.begin(), beacon.word.end())) {
    table.problem(
        "word", ErrorCode::BadParameter,
        {"word must be whole numbers, one for each event", "word debe tener números enteros, uno por cada evento"});
  }
  if (events.size() > kMaxWord) {
    table.problem("word", ErrorCode::TooLarge,
                  {"word has {} events; the limit is {}", "word tiene {} eventos; el límite es {}"}, events.size(),
                  kMaxWord);
  }
  const double sound_range_m = table.number("sound_range_m", 5, kExtent);
  beacon.sound_range_m = table.has("word") ? sound_range_m : 0;
  beacon.event_s = table.number("event_s", 0.3, kTime);
  beacon.pause_s = table.number("pause_s", 2, {0, 1e6});
  beacon.start_s = table.number("start_s", 0, {0, 1e6});
}

}  // namespace

void read_floor(config::Table& root, ItemIds& ids, GroundPlan& plan) {
  read_zones(root, ids, plan.floor);
  read_bumps(root, ids, plan.floor);
}

void read_beacons(config::Table& root, ItemIds& ids, GroundPlan& plan) {
  for (config::Table& table : root.tables("beacon")) {
    Beacon beacon;
    beacon.id = ids.read(table, true);
    beacon.label = table.text("label", "");
    beacon.position = read_position(table);
    beacon.height_m = table.number("height_m", 0.3, {0, 100});
    beacon.light_range_m = table.number("light_range_m", 0, {0, kMaxCoordinate_m});
    beacon.colour = read_colour(table, beacon.colour);
    read_word(table, beacon);
    if (beacon.word.empty() && !(beacon.light_range_m > 0)) {
      table.problem("id", ErrorCode::BadParameter,
                    {"a beacon shines (light_range_m > 0), chirps (word = [1, 2]) or both",
                     "una baliza brilla (light_range_m > 0), suena (word = [1, 2]) o ambas cosas"});
    }
    plan.beacons.push_back(std::move(beacon));
  }
}

}  // namespace ganglion::sim
