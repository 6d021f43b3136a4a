#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "ganglion/plot/picture/ground.h"
#include "ganglion/plot/picture/pictures.h"

namespace ganglion::plot {
namespace {

constexpr double kMaxWidth_px = 620;
constexpr double kSideWidth_px = 210;
constexpr int kMaxCellsDrawn = 400;  // each way; beyond, cells are drawn in blocks that show their highest risk
const Pen kCellEdge{Colour::hex(0xffffff).faded(0.35), 0.6, {}};
const Pen kHatch{Colour::hex(0xffffff), 1.1, {}};
const Pen kHatchShade{Colour::hex(0x101418), 2.4, {}};
const Pen kWallHalo{Colour::hex(0xffffff).faded(0.7), 2.6, {}};
const Pen kWallLine{Colour::hex(0x22272e), 1.4, {4, 2, 4, 2}};
using Rectangle = std::array<Vector2, 2>;

/// Cells as they are drawn: a block of `step` x `step` cells at a time.
class Cells {
 public:
  Cells(const MapFrame& frame, double cell_m) : frame_(frame), cell_m_(cell_m) {
    for (int row = 0; row < frame.rows; ++row)
      for (int column = 0; column < frame.columns; ++column)
        if (known(index(column, row))) {
          lower_[0] = std::min(lower_[0], column), lower_[1] = std::min(lower_[1], row);
          upper_[0] = std::max(upper_[0], column + 1), upper_[1] = std::max(upper_[1], row + 1);
        }
    if (lower_[0] > upper_[0]) lower_ = {0, 0}, upper_ = {frame.columns, frame.rows};
    step_ = std::max(1, (std::max(upper_[0] - lower_[0], upper_[1] - lower_[1]) + kMaxCellsDrawn - 1) / kMaxCellsDrawn);
  }

  Vector2 lower() const noexcept { return frame_.origin + Vector2{lower_[0] - 1.0, lower_[1] - 1.0} * cell_m_; }
  Vector2 upper() const noexcept { return frame_.origin + Vector2{upper_[0] + 1.0, upper_[1] + 1.0} * cell_m_; }
  double block_m() const noexcept { return step_ * cell_m_; }

  /// Calls `use(lower corner [m], risk in [0, 1], label, dynamic, inhibited)` for every explored block.
  template <class Use>
  void for_each(Use use) const {
    for (int row = lower_[1]; row < upper_[1]; row += step_)
      for (int column = lower_[0]; column < upper_[0]; column += step_) visit(column, row, use);
  }

 private:
  std::size_t index(int column, int row) const noexcept {
    return static_cast<std::size_t>(row) * frame_.columns + column;
  }
  static std::uint8_t get(const std::vector<std::uint8_t>& layer, std::size_t i) noexcept {
    return i < layer.size() ? layer[i] : 0;
  }
  bool known(std::size_t i) const noexcept {
    return get(frame_.label, i) != 0 || get(frame_.risk, i) != 0 || get(frame_.inhibited, i) != 0;
  }
  template <class Use>
  void visit(int column, int row, Use use) const {
    std::uint8_t risk = 0, label = 0, dynamic = 0, inhibited = 0;
    bool any = false;
    for (int r = row; r < std::min(row + step_, upper_[1]); ++r)
      for (int c = column; c < std::min(column + step_, upper_[0]); ++c) {
        const std::size_t i = index(c, r);
        any = any || known(i);
        risk = std::max(risk, get(frame_.risk, i)), label = std::max(label, get(frame_.label, i));
        dynamic = std::max(dynamic, get(frame_.dynamic, i)), inhibited = std::max(inhibited, get(frame_.inhibited, i));
      }
    if (any)
      use(frame_.origin + Vector2{double(column), double(row)} * cell_m_, risk / 255.0, CellLabel{label}, dynamic,
          inhibited);
  }

  const MapFrame& frame_;
  double cell_m_;
  std::array<int, 2> lower_{1 << 30, 1 << 30};
  std::array<int, 2> upper_{-1, -1};
  int step_ = 1;
};

Colour readable_on(Colour ground) noexcept { return Colour::hex(ground.brightness() > 0.5 ? 0x101418 : 0xffffff); }

void draw_grid(Canvas& canvas, const Axes& axes, const Cells& cells) {
  const double step_m = cells.block_m();
  for (double x = cells.lower().x; x <= cells.upper().x + step_m / 2; x += step_m)
    canvas.line(axes.at({x, cells.lower().y}), axes.at({x, cells.upper().y}), kCellEdge);
  for (double y = cells.lower().y; y <= cells.upper().y + step_m / 2; y += step_m)
    canvas.line(axes.at({cells.lower().x, y}), axes.at({cells.upper().x, y}), kCellEdge);
}

void draw_cells(Canvas& canvas, const Axes& axes, const Cells& cells) {
  const double side_px = cells.block_m() * axes.scale();
  const auto corner_of = [&](Vector2 lower) { return axes.at(lower + Vector2{0, cells.block_m()}); };
  std::vector<Rectangle> occupied;
  std::map<double, std::vector<Rectangle>> by_risk;
  cells.for_each([&](Vector2 lower, double risk, CellLabel label, int, int) {
    const Rectangle cell{corner_of(lower), {side_px, side_px}};
    by_risk[risk].push_back(cell);
    if (label == CellLabel::Occupied) occupied.push_back(cell);
  });
  for (const auto& [risk, same] : by_risk) canvas.rectangles(same, viridis(risk));
  if (side_px >= 8) draw_grid(canvas, axes, cells);
  const double gap_px = std::clamp(side_px / 3, 4.0, 9.0);
  canvas.hatch(occupied, gap_px, kHatchShade);
  canvas.hatch(occupied, gap_px, kHatch);
  if (side_px < 6) return;
  const double mark_px = std::clamp(side_px * 0.5, 5.0, 12.0);
  cells.for_each([&](Vector2 lower, double risk, CellLabel, int dynamic, int inhibited) {
    const Vector2 centre = corner_of(lower) + Vector2{side_px, side_px} * 0.5;
    if (inhibited > 0)
      canvas.marker(4, centre, mark_px + 2, Colour::hex(0xb3123a)),
          canvas.marker(4, centre, mark_px - 1, Colour::hex(0xffffff));
    else if (dynamic > 0)
      canvas.disc(centre, mark_px / 5, readable_on(viridis(risk)));
  });
}

void draw_colour_bar(Canvas& canvas, Vector2 corner, double height_px, std::string_view name) {
  constexpr double kBar_px = 18;
  constexpr int kSteps = 64;
  for (int i = 0; i < kSteps; ++i)
    canvas.rectangle(corner + Vector2{0, height_px * (kSteps - 1 - i) / kSteps}, {kBar_px, height_px / kSteps + 0.6},
                     viridis((i + 0.5) / kSteps));
  canvas.rectangle(corner, {kBar_px, height_px}, Pen{Colour::hex(0x5b6470), 1, {}});
  for (const double risk : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double y = corner.y + height_px * (1 - risk);
    canvas.line({corner.x + kBar_px, y}, {corner.x + kBar_px + 4, y}, {Colour::hex(0x5b6470), 1, {}});
    canvas.text({corner.x + kBar_px + 8, y + 4}, tick_label(risk), Anchor::Start, {.size_px = 11});
  }
  canvas.text(corner - Vector2{0, 10}, name, Anchor::Start, {.size_px = 12, .bold = true});
}

Legend make_legend(const Words& words, bool walls) {
  const Vector2 half{9, 8};
  const auto cell = [half](Canvas& canvas, Vector2 centre) {
    canvas.rectangle(centre - half, 2 * half, viridis(0.35));
  };
  Legend legend;
  legend.add(std::string(words.occupied), [=](Canvas& canvas, Vector2 centre) {
    cell(canvas, centre);
    const std::array<Rectangle, 1> box{Rectangle{centre - half, 2 * half}};
    canvas.hatch(box, 6, kHatchShade);
    canvas.hatch(box, 6, kHatch);
  });
  legend.add(std::string(words.dynamic), [=](Canvas& canvas, Vector2 centre) {
    cell(canvas, centre);
    canvas.disc(centre, 2.4, Colour::hex(0xffffff));
  });
  legend.add(std::string(words.inhibited), [=](Canvas& canvas, Vector2 centre) {
    cell(canvas, centre);
    canvas.marker(4, centre, 12, Colour::hex(0xb3123a));
    canvas.marker(4, centre, 9, Colour::hex(0xffffff));
  });
  legend.add(std::string(words.unexplored), [=](Canvas& canvas, Vector2 centre) {
    canvas.rectangle(centre - half, 2 * half, Pen{Colour::hex(0x5b6470), 1, {}});
  });
  if (walls) legend.add_line(std::string(words.true_outline), kWallLine);
  return legend;
}

void draw_true_walls(Canvas& canvas, const Axes& axes, const Scene& scene) {
  for (const auto* outlines : {&scene.walls, &scene.furniture})
    for (const Outline& outline : *outlines) {
      std::vector<Vector2> points;
      for (const Vector2 p : outline.points) points.push_back(axes.at(p));
      if (outline.closed && !points.empty()) points.push_back(points.front());
      canvas.line(points, kWallHalo);
      canvas.line(points, kWallLine);
    }
}

Picture map_picture(const RunView& run, const RobotView& robot, const MapView& map, Language language) {
  const Words& said = words(language);
  const MapFrame& frame = map.frames.back();
  const Cells cells(frame, map.cell_m);
  const Vector2 corner{62, 44};
  const Axes axes = equal_axes(cells.lower(), cells.upper(), corner, {kMaxWidth_px, kMaxWidth_px});
  const Legend legend = make_legend(said, !run.scene.walls.empty() || !run.scene.furniture.empty());
  const double bar_px = 150;
  const double side_px = 24 + bar_px + 26 + legend.height_px() + 46;
  const double height_px = corner.y + std::max(axes.size_px.y, side_px) + 48;
  const double left = axes.right() + 28;
  std::string title =
      fmt::format("{}: {} {}, {:.4g} s", std::string_view(said.learned_map), robot.name, map.component, frame.time_s);
  auto draw = [&run, &said, axes, cells, legend, left, bar_px, title](Canvas& canvas) {
    canvas.text({axes.corner_px.x, 26}, canvas.fitted(title, left + kSideWidth_px - axes.corner_px.x), Anchor::Start,
                {.size_px = 15, .bold = true});
    canvas.clip(axes.corner_px, axes.size_px);
    draw_cells(canvas, axes, cells);
    draw_true_walls(canvas, axes, run.scene);
    canvas.unclip();
    draw_axes(canvas, axes, "x [m]", "y [m]");
    draw_colour_bar(canvas, {left, axes.corner_px.y + 24}, bar_px, said.risk);
    const double below = axes.corner_px.y + 24 + bar_px + 26;
    legend.draw(canvas, {left, below}, kSideWidth_px, said.legend);
    draw_scale_bar(canvas, {left, below + legend.height_px() + 16}, axes.scale(), kSideWidth_px - 60);
  };
  return {file_stem(fmt::format("map-{}-{}", robot.name, map.component)),
          std::move(title),
          std::string(said.learned_map_about),
          left + kSideWidth_px + 10,
          height_px,
          std::move(draw)};
}

}  // namespace

std::vector<Picture> learned_map_pictures(const RunView& run, Language language) {
  std::vector<Picture> pictures;
  for (std::size_t i = 0; i < std::min(run.robots.size(), kMaxDrawnRobots); ++i)
    for (const MapView& map : run.robots[i].maps)
      if (!map.frames.empty() && map.frames.back().columns > 0 && map.frames.back().rows > 0 && map.cell_m > 0)
        pictures.push_back(map_picture(run, run.robots[i], map, language));
  return pictures;
}

}  // namespace ganglion::plot
