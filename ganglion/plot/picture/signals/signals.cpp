#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ganglion/plot/picture/ground.h"
#include "ganglion/plot/picture/picture_kind.h"

namespace ganglion::plot {
namespace {

constexpr double kPanelHeight_px = 62;
constexpr double kPitch_px = 96;  // from one panel to the next below
constexpr double kTop_px = 78;
constexpr std::size_t kMaxPanels = 60;
const Colour kLine = Colour::hex(0x1c437e);
const Colour kMark = Colour::hex(0xb3123a);
const Colour kGap = Colour::hex(0xe6e1d8);
const Pen kFrame{Colour::hex(0xb4bbc3), 0.8, {}};

/// What a column holds, to choose the axis and the way of drawing.
struct Range {
  double lower = INFINITY;
  double upper = -INFINITY;
  bool whole = true;  ///< All finite values are whole numbers: drawn as steps.
};

Range range_of(const SignalTable& table, std::size_t column) noexcept {
  Range range;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double value = table.at(row, column);
    if (!std::isfinite(value)) continue;
    range.lower = std::min(range.lower, value);
    range.upper = std::max(range.upper, value);
    range.whole = range.whole && value == std::floor(value);
  }
  return range;
}

/// An axis a little wider than the values; a constant gets one around itself.
std::pair<double, double> axis_around(const Range& range) noexcept {
  if (range.lower > range.upper) return {0, 1};
  const double spread = range.upper - range.lower;
  if (!std::isfinite(spread)) return {range.lower, range.upper};
  const double pad = spread > 0 ? 0.06 * spread : std::max(0.5, 0.1 * std::fabs(range.upper));
  return {range.lower - pad, range.upper + pad};
}

/// One signal in its panel: a line broken where there is no reading, marks at the edges for +inf and -inf. Of the rows
/// that fall on one pixel only the least and the greatest are drawn.
class Panel {
 public:
  Panel(Canvas& canvas, const Axes& axes, const SignalTable& table, std::size_t column, bool steps)
      : canvas_(canvas), axes_(axes), table_(table), column_(column), steps_(steps) {}

  /// Shades the times without a reading.
  void draw_gaps() {
    for (std::size_t row = 0; row < table_.rows();) {
      std::size_t next = row + 1;
      if (std::isnan(table_.at(row, column_))) {
        while (next < table_.rows() && std::isnan(table_.at(next, column_))) ++next;
        const double left = axes_.x_at(table_.times_s[row]);
        const double right = axes_.x_at(table_.times_s[std::min(next, table_.rows() - 1)]);
        canvas_.rectangle({left, axes_.corner_px.y}, {std::max(0.8, right - left), axes_.size_px.y}, kGap);
      }
      row = next;
    }
  }
  void draw() {
    std::size_t row = 0;
    while (row < table_.rows()) {
      const double pixel = std::floor(axes_.x_at(table_.times_s[row]));
      std::size_t next = row;
      while (next < table_.rows() && std::floor(axes_.x_at(table_.times_s[next])) == pixel) ++next;
      draw_pixel(row, next);
      row = next;
    }
    finish();
  }

 private:
  void draw_pixel(std::size_t from, std::size_t to) {
    std::size_t least = to, greatest = to;
    bool beyond = false, below = false;
    for (std::size_t row = from; row < to; ++row) {
      const double value = table_.at(row, column_);
      beyond = beyond || value == INFINITY;
      below = below || value == -INFINITY;
      if (!std::isfinite(value)) continue;
      if (least == to || value < table_.at(least, column_)) least = row;
      if (greatest == to || value > table_.at(greatest, column_)) greatest = row;
    }
    const double x = axes_.x_at(table_.times_s[from]);
    if (beyond) mark(x, axes_.corner_px.y + 3, -1, last_beyond_px_);
    if (below) mark(x, axes_.bottom() - 3, 1, last_below_px_);
    if (least == to) return finish();
    add(std::min(least, greatest));
    if (least != greatest) add(std::max(least, greatest));
  }
  void add(std::size_t row) {
    const Vector2 p = axes_.at({table_.times_s[row], table_.at(row, column_)});
    if (steps_ && !points_.empty() && points_.back().y != p.y) points_.push_back({p.x, points_.back().y});
    points_.push_back(p);
  }
  void finish() {
    if (points_.size() == 1) canvas_.disc(points_[0], 1.2, kLine);
    canvas_.line(points_, {kLine, 1.3, {}});
    points_.clear();
  }
  void mark(double x, double y, int down, double& last_px) {
    if (x - last_px < 6) return;
    last_px = x;
    canvas_.polygon(
        std::array{Vector2{x, y + 3.5 * down}, Vector2{x - 3, y - 2.5 * down}, Vector2{x + 3, y - 2.5 * down}}, kMark);
  }

  Canvas& canvas_;
  const Axes& axes_;
  const SignalTable& table_;
  std::size_t column_;
  bool steps_;
  double last_beyond_px_ = -1e9;
  double last_below_px_ = -1e9;
  std::vector<Vector2> points_;
};

void draw_value_ticks(Canvas& canvas, const Axes& axes) {
  for (const double value : round_ticks(axes.lower.y, axes.upper.y, 4)) {
    const double y = axes.y_at(value);
    canvas.line({axes.corner_px.x, y}, {axes.right(), y}, {Colour::hex(0xdfe3e8), 0.7, {}});
    canvas.text({axes.corner_px.x - 5, y + 4}, tick_label(value), Anchor::End, {.size_px = 10});
  }
}

void draw_signal(Canvas& canvas, Vector2 corner, double width_px, const SignalTable& table, std::size_t column,
                 double duration_s, const Words& said) {
  const Range range = range_of(table, column);
  const auto [lower, upper] = axis_around(range);
  const Axes axes{corner + Vector2{58, 16}, {width_px - 66, kPanelHeight_px}, {0, lower}, {duration_s, upper}};
  canvas.text(corner + Vector2{58, 11},
              canvas.fitted(with_unit(table.columns[column].name, table.columns[column].unit), width_px - 66),
              Anchor::Start, {.size_px = 11.5, .bold = true});
  Panel panel(canvas, axes, table, column, range.whole);
  const bool finite = range.lower <= range.upper;
  panel.draw_gaps();
  if (finite) draw_value_ticks(canvas, axes);
  canvas.clip(axes.corner_px, axes.size_px);
  panel.draw();
  canvas.unclip();
  canvas.rectangle(axes.corner_px, axes.size_px, kFrame);
  if (finite) return;
  const bool rows = table.rows() > 0;
  canvas.text(axes.corner_px + axes.size_px * 0.5 + Vector2{0, 4}, rows ? said.no_reading : said.no_data,
              Anchor::Middle, {.colour = Colour::hex(0x4b535d), .size_px = 11});
}

/// Which readings a page has that are no numbers.
struct Gaps {
  bool missing = false, beyond = false, below = false;
};

Gaps gaps_of(const SignalTable& table, std::size_t first, std::size_t last) {
  Gaps gaps;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t column = first; column < last; ++column) {
      const double value = table.at(row, column);
      if (std::isfinite(value)) continue;
      gaps.missing = gaps.missing || std::isnan(value);
      gaps.beyond = gaps.beyond || value > 0;
      gaps.below = gaps.below || value < 0;
    }
  }
  gaps.missing = gaps.missing || table.rows() == 0;
  return gaps;
}

/// Explains the signs that the page has.
void draw_gap_legend(Canvas& canvas, Vector2 at, const Words& said, const Gaps& gaps) {
  const TextStyle small{.size_px = 11};
  const auto write = [&](WordOf word, double sample_px) {
    canvas.text(at + Vector2{sample_px, 0}, said.*word, Anchor::Start, small);
    at.x += sample_px + widest(canvas, word, small) + 24;
  };
  if (gaps.missing) {
    canvas.rectangle(at - Vector2{0, 10}, {22, 13}, kGap);
    write(&Words::no_reading, 28);
  }
  if (gaps.beyond) {
    canvas.polygon(std::array{at + Vector2{5, -9}, at + Vector2{1, -1}, at + Vector2{9, -1}}, kMark);
    write(&Words::nothing_in_range, 14);
  }
  if (gaps.below) {
    canvas.polygon(std::array{at + Vector2{5, -1}, at + Vector2{1, -9}, at + Vector2{9, -9}}, kMark);
    write(&Words::too_close, 14);
  }
}

Picture page(const RobotView& robot, double duration_s, std::size_t first, std::size_t last, Language language) {
  const Words& said = words(language);
  const std::size_t per_column = (last - first + 1) / 2;
  const double height_px = kTop_px + kPitch_px * static_cast<double>(per_column) + 36;
  const std::string number = first == 0 ? "" : fmt::format(" {}", first / kMaxPanels + 1);
  std::string title = fmt::format("{}: {}{}", std::string_view(said.signals), robot.name, number);
  auto draw = [&robot, &said, duration_s, first, last, per_column, title](Canvas& canvas) {
    canvas.text({16, 26}, canvas.fitted(title, kPictureWidth_px - 40), Anchor::Start, {.size_px = 15, .bold = true});
    draw_gap_legend(canvas, {16, 52}, said, gaps_of(robot.signals, first, last));
    const double width_px = (kPictureWidth_px - 24) / 2;
    const double length_s = std::max(duration_s, 1e-3);
    for (std::size_t i = first; i < last; ++i) {
      const std::size_t place = i - first;
      const Vector2 corner{12 + width_px * static_cast<double>(place / per_column),
                           kTop_px + kPitch_px * static_cast<double>(place % per_column)};
      draw_signal(canvas, corner, width_px, robot.signals, i, length_s, said);
      if (place % per_column + 1 == per_column || i + 1 == last) {
        const Axes below{corner + Vector2{58, 16}, {width_px - 66, kPanelHeight_px}, {0, 0}, {length_s, 1}};
        draw_time_axis(canvas, below, with_unit(said.time, "s"));
      }
    }
  };
  return {file_stem(fmt::format("signals-{}{}", robot.name, number)),
          std::move(title),
          std::string(said.signals_about),
          kPictureWidth_px,
          height_px,
          std::move(draw)};
}

bool wants(const RunView& run) {
  return std::ranges::any_of(run.robots, [](const RobotView& robot) { return !robot.signals.columns.empty(); });
}

std::vector<Picture> draw(const RunView& run, Language language) {
  std::vector<Picture> pictures;
  for (std::size_t i = 0; i < std::min(run.robots.size(), kMaxDrawnRobots); ++i) {
    const std::size_t columns = run.robots[i].signals.columns.size();
    for (std::size_t first = 0; first < columns; first += kMaxPanels)
      pictures.push_back(page(run.robots[i], run.duration_s, first, std::min(first + kMaxPanels, columns), language));
  }
  return pictures;
}

}  // namespace

extern const PictureKind signals_kind;
constinit const PictureKind signals_kind{
    .descriptor = {.component_class = ComponentClass::Picture,
                   .name = "Signals",
                   .summary = {"Every signal of a robot against time, at most 60 panels a picture.",
                               "Cada señal de un robot frente al tiempo, con 60 paneles por imagen como máximo."},
                   .source = "ours"},
    .order = 90,
    .wants = wants,
    .draw = draw};

}  // namespace ganglion::plot
