#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "ganglion/plot/picture/ground.h"
#include "ganglion/plot/picture/picture_kind.h"
#include "ganglion/plot/picture/shapes.h"

namespace ganglion::plot {
namespace {

constexpr double kLegendWidth_px = 220;
constexpr double kLeast_px = 0.4;  // nearer points of a path are left out
constexpr double kMarkerEvery_px = 46;
const Colour kStart = Colour::hex(0x1e9e3a);
const Colour kArrows = Colour::hex(0x1b7f36);
const Colour kDark = Colour::hex(0x22272e);
const Colour kContact = Colour::hex(0xb3123a);
const LineLook kNobody{Colour::hex(0x7b838d), {1.5, 3, 1.5, 3}, -1};

/// Which behaviour drives when; robots without a coordinator have none.
class Driver {
 public:
  explicit Driver(const RobotView& robot)
      : coordination_(robot.coordinations.empty() ? nullptr : &robot.coordinations.front()) {}
  bool known() const noexcept { return coordination_ != nullptr; }
  /// Index of the candidate; -1 = none.
  int at(double time_s) const noexcept {
    const auto row = coordination_ ? index_at(coordination_->times_s, time_s) : std::nullopt;
    return row ? coordination_->active[*row] : -1;
  }

 private:
  const Coordination* coordination_;
};

void draw_marker(Canvas& canvas, const LineLook& line, bool arrows, Vector2 at, Vector2 heading) {
  if (arrows)
    canvas.arrow_head(at, heading, 11, line.colour);
  else if (line.marker >= 0)
    canvas.marker(line.marker, at, 7, line.colour);
}

LineLook look_of(int behaviour, bool arrows) noexcept {
  if (arrows) return {kArrows, {0, 0, 0, 0}, -1};
  return behaviour < 0 ? kNobody : look(behaviour);
}

/// Draws one robot's way, a piece for each spell of a behaviour, with markers at even distances along it.
class Way {
 public:
  Way(Canvas& canvas, const Axes& axes, const RobotView& robot)
      : canvas_(canvas), axes_(axes), robot_(robot), driver_(robot), arrows_(!driver_.known()) {}

  void draw() {
    const Track& track = robot_.track;
    for (std::size_t i = 0; i < track.times_s.size(); ++i) {
      const Vector2 p = axes_.at({track.x_m[i], track.y_m[i]});
      const int behaviour = driver_.at(track.times_s[i]);
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
        finish(behaviour);
        piece_.clear();
        continue;
      }
      if (behaviour != behaviour_) {
        if (!piece_.empty()) piece_.push_back(p);
        finish(behaviour);
        piece_.assign(1, p);
      }
      step_to(p);
    }
    finish(-1);
  }

 private:
  void step_to(Vector2 p) {
    if (piece_.empty()) piece_.push_back(p);
    const Vector2 step = p - piece_.back();
    if (step.length() < kLeast_px) return;
    since_marker_px_ += step.length();
    piece_.push_back(p);
    if (since_marker_px_ < kMarkerEvery_px) return;
    since_marker_px_ = 0;
    markers_.push_back({p, step});
  }
  void finish(int next_behaviour) {
    const LineLook line = look_of(behaviour_, arrows_);
    canvas_.line(piece_, {line.colour, 2, line.dash_px});
    for (const auto& [at, heading] : markers_) draw_marker(canvas_, line, arrows_, at, heading);
    markers_.clear();
    if (next_behaviour != behaviour_) since_marker_px_ = kMarkerEvery_px * 0.6;
    behaviour_ = next_behaviour;
  }

  Canvas& canvas_;
  const Axes& axes_;
  const RobotView& robot_;
  Driver driver_;
  bool arrows_;
  int behaviour_ = -1;
  double since_marker_px_ = 0;
  std::vector<Vector2> piece_;
  std::vector<std::pair<Vector2, Vector2>> markers_;
};

std::vector<Vector2> contacts(const RobotView& robot) {
  std::vector<Vector2> places;
  const Track& track = robot.track;
  for (std::size_t i = 0; i < track.touching.size(); ++i)
    if (track.touching[i] && (i == 0 || !track.touching[i - 1]) && std::isfinite(track.x_m[i] + track.y_m[i]))
      places.push_back({track.x_m[i], track.y_m[i]});
  return places;
}

void draw_contact(Canvas& canvas, Vector2 at) { canvas.marker(4, at, 9, kContact); }
void draw_start(Canvas& canvas, Vector2 at) { canvas.disc(at, 6.5, kStart, {kDark, 1, {}}); }
void draw_end(Canvas& canvas, Vector2 at) {
  canvas.rectangle(at - Vector2{8, 8}, {16, 16}, Pen{Colour::hex(0xffffff), 4.5, {}});
  canvas.rectangle(at - Vector2{8, 8}, {16, 16}, Pen{kDark, 2, {}});
}

void draw_robot_marks(Canvas& canvas, const Axes& axes, const RobotView& robot) {
  for (const Vector2 place : contacts(robot)) draw_contact(canvas, axes.at(place));
}

void draw_ends(Canvas& canvas, const Axes& axes, const RobotView& robot) {
  const Track& track = robot.track;
  if (track.times_s.empty()) return;
  draw_start(canvas, axes.at({track.x_m.front(), track.y_m.front()}));
  draw_end(canvas, axes.at({track.x_m.back(), track.y_m.back()}));
}

/// Names several robots beside their starts.
void draw_names(Canvas& canvas, const Axes& axes, const RunView& run) {
  if (run.robots.size() < 2 || run.robots.size() > 12) return;
  for (const RobotView& robot : run.robots)
    if (!robot.track.times_s.empty()) {
      const Vector2 at = axes.at({robot.track.x_m.front(), robot.track.y_m.front()});
      const std::string name = canvas.fitted(robot.name, 90);
      const double width = canvas.text_width(name);
      const bool left = at.x + 16 + width > axes.right();
      const double x = left ? at.x - 16 - width : at.x + 16;
      canvas.rectangle({x - 2, at.y - 9}, {width + 4, 16}, Colour::hex(0xffffff).faded(0.85));
      canvas.text({x, at.y + 4}, name);
    }
}

void add_behaviours(Legend& legend, const RunView& run, const Words& words) {
  std::set<std::string> seen;
  bool nobody = false;
  for (const RobotView& robot : run.robots) {
    if (robot.coordinations.empty()) continue;
    const Coordination& coordination = robot.coordinations.front();
    for (std::size_t i = 0; i < coordination.candidates.size(); ++i) {
      const bool drove =
          std::ranges::find(coordination.active, static_cast<std::int16_t>(i)) != coordination.active.end();
      if (!drove || !seen.insert(fmt::format("{}:{}", i, coordination.candidates[i])).second) continue;
      const LineLook line = look(static_cast<int>(i));
      legend.add_line(coordination.candidates[i], {line.colour, 2, line.dash_px}, line.marker);
    }
    nobody = nobody || std::ranges::find(coordination.active, -1) != coordination.active.end();
  }
  if (nobody) legend.add_line(std::string(words.no_behaviour), {kNobody.colour, 2, kNobody.dash_px});
}

Legend make_legend(const RunView& run, std::span<const PlacedShape> shapes, Language language) {
  const Words& words = plot::words(language);
  Legend legend;
  const auto any = [&](auto test) { return std::ranges::any_of(run.robots, test); };
  legend.add(std::string(words.start), draw_start);
  legend.add(std::string(words.end), draw_end);
  if (any([](const RobotView& robot) { return robot.coordinations.empty(); }))
    legend.add(std::string(words.path), [](Canvas& canvas, Vector2 centre) {
      canvas.line(centre - Vector2{16, 0}, centre + Vector2{12, 0}, {kArrows, 2, {}});
      canvas.arrow_head(centre + Vector2{11, 0}, {1, 0}, 11, kArrows);
    });
  add_behaviours(legend, run, words);
  if (any([](const RobotView& robot) { return !contacts(robot).empty(); }))
    legend.add(std::string(words.contact), draw_contact);
  add_shapes_to_legend(legend, shapes, language);
  add_ground_to_legend(legend, run.scene, words);
  return legend;
}

/// What was shown and lasts: a plan of the last moment, or what a robot sees then, tells nothing of the whole run.
std::vector<PlacedShape> still_shapes(const RunView& run) {
  std::vector<PlacedShape> shapes = lasting_shapes(run);
  std::erase_if(shapes, [](const PlacedShape& placed) {
    const Role role = placed.shape->role;
    return role == Role::Plan || role == Role::Echo || role == Role::Sensing;
  });
  // Lines lie below the ways, the rest above them.
  std::ranges::stable_partition(shapes, [](const PlacedShape& placed) { return placed.shape->form == Form::Polyline; });
  return shapes;
}

Picture trajectory_picture(const RunView& run, Language language) {
  const Words& said = words(language);
  const std::vector<PlacedShape> shapes = still_shapes(run);
  const Bounds bounds = bounds_of(run);
  const Vector2 margin = 0.03 * (bounds.upper - bounds.lower);
  const Vector2 corner{62, 44};
  const Vector2 room{kPictureWidth_px - corner.x - kLegendWidth_px - 40, 760};
  const Axes axes = equal_axes(bounds.lower - margin, bounds.upper + margin, corner, room);
  const Legend legend = make_legend(run, shapes, language);
  const double height_px = corner.y + std::max(axes.size_px.y, legend.height_px() + 50) + 48;
  const double legend_left = axes.right() + 28;
  auto draw = [&run, &said, axes, legend, legend_left, shapes, language](Canvas& canvas) {
    canvas.text({axes.corner_px.x, 26},
                canvas.fitted(fmt::format("{}: {}", std::string_view(said.trajectory), run.name), 800), Anchor::Start,
                {.size_px = 15, .bold = true});
    draw_ground(canvas, axes, run.scene, run.duration_s);
    canvas.clip(axes.corner_px, axes.size_px);
    const auto lines =
        std::ranges::count(shapes, Form::Polyline, [](const auto& placed) { return placed.shape->form; });
    const std::span<const PlacedShape> all(shapes);
    draw_shapes(canvas, axes, all.first(static_cast<std::size_t>(lines)), language);
    for (const RobotView& robot : run.robots) Way(canvas, axes, robot).draw();
    for (const RobotView& robot : run.robots) draw_robot_marks(canvas, axes, robot);
    draw_shapes(canvas, axes, all.subspan(static_cast<std::size_t>(lines)), language);
    for (const RobotView& robot : run.robots) draw_ends(canvas, axes, robot);
    draw_names(canvas, axes, run);
    canvas.unclip();
    draw_axes(canvas, axes, "x [m]", "y [m]");
    legend.draw(canvas, {legend_left, axes.corner_px.y}, kLegendWidth_px, said.legend);
    draw_scale_bar(canvas, {legend_left, axes.corner_px.y + legend.height_px() + 22}, axes.scale(),
                   kLegendWidth_px - 60);
  };
  const double width_px = std::max(legend_left + kLegendWidth_px + 10, 480.0);
  return {"trajectory",   std::string(said.trajectory), std::string(said.trajectory_about), width_px, height_px,
          std::move(draw)};
}

bool wants(const RunView& run) { return run.scene.bounds || has_way(run); }

std::vector<Picture> draw(const RunView& run, Language language) { return {trajectory_picture(run, language)}; }

}  // namespace

extern const PictureKind trajectory_kind;
constinit const PictureKind trajectory_kind{
    .descriptor = {.component_class = ComponentClass::Picture,
                   .name = "Trajectory",
                   .summary = {"The way of every robot over the ground, with what was shown on it.",
                               "El camino de cada robot sobre el suelo, con lo que se mostró en él."},
                   .source = "\"A growing functional modules locomotion subsystem\", figure 7"},
    .order = 10,
    .wants = wants,
    .draw = draw};

}  // namespace ganglion::plot
