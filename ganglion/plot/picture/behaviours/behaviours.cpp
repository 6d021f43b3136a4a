#include <fmt/format.h>

#include <algorithm>

#include "ganglion/plot/picture/ground.h"
#include "ganglion/plot/picture/picture_kind.h"

namespace ganglion::plot {
namespace {

constexpr double kNames_px = 170;
constexpr double kBand_px = 30;
constexpr double kHead_px = 30;  // name of a coordinator above its bands
constexpr double kFoot_px = 52;
constexpr std::size_t kMaxBands = 24;
const Pen kEdge{Colour::hex(0x8a929c), 0.8, {}};

/// Part of the command a candidate has at a row: 1 or 0 where the winner takes all.
double share_of(const Coordination& coordination, std::size_t row, std::size_t candidate) noexcept {
  if (coordination.shares.empty()) return coordination.active[row] == static_cast<int>(candidate) ? 1 : 0;
  const double share = coordination.shares[row * coordination.candidates.size() + candidate];
  return share > 0 ? std::min(share, 1.0) : 0;
}

double end_of(const Coordination& coordination, std::size_t row, double duration_s) noexcept {
  return row + 1 < coordination.times_s.size() ? coordination.times_s[row + 1]
                                               : std::max(duration_s, coordination.times_s[row]);
}

/// Draws one candidate: solid while it drives (as high as its share), hatched while it is suppressed.
void draw_band(Canvas& canvas, const Axes& axes, const Coordination& coordination, std::size_t candidate,
               double duration_s) {
  const std::size_t rows = coordination.times_s.size();
  const LineLook line = look(static_cast<int>(candidate));
  std::vector<std::array<Vector2, 2>> suppressed;
  for (std::size_t row = 0; row < rows;) {
    const double share = share_of(coordination, row, candidate);
    const bool wants = coordination.wants(row, candidate);
    std::size_t next = row + 1;
    while (next < rows && share_of(coordination, next, candidate) == share &&
           coordination.wants(next, candidate) == wants)
      ++next;
    const double left = axes.x_at(coordination.times_s[row]);
    const double width = std::max(0.6, axes.x_at(end_of(coordination, next - 1, duration_s)) - left);
    if (share > 0)
      canvas.rectangle({left, axes.bottom() - share * axes.size_px.y}, {width, share * axes.size_px.y}, line.colour);
    else if (wants)
      suppressed.push_back({Vector2{left, axes.corner_px.y}, Vector2{width, axes.size_px.y}});
    row = next;
  }
  canvas.hatch(suppressed, 5, {line.colour, 1.2, {}});
  canvas.rectangle(axes.corner_px, axes.size_px, kEdge);
}

double height_of(const Coordination& coordination) noexcept {
  return kHead_px + kBand_px * static_cast<double>(std::min(coordination.candidates.size(), kMaxBands)) + kFoot_px;
}

void draw_coordination(Canvas& canvas, const Coordination& coordination, double top, double duration_s,
                       const Words& said) {
  canvas.text({16, top + 18}, canvas.fitted(coordination.coordinator, kPictureWidth_px - 40), Anchor::Start,
              {.size_px = 13, .bold = true});
  const double length_s = std::max(duration_s, 1e-3);
  Axes axes{{kNames_px, top + kHead_px}, {kPictureWidth_px - kNames_px - 20, kBand_px - 6}, {0, 0}, {length_s, 1}};
  for (std::size_t i = 0; i < std::min(coordination.candidates.size(), kMaxBands); ++i) {
    canvas.text({kNames_px - 10, axes.bottom() - 7}, canvas.fitted(coordination.candidates[i], kNames_px - 24),
                Anchor::End);
    draw_band(canvas, axes, coordination, i, length_s);
    axes.corner_px.y += kBand_px;
  }
  axes.corner_px.y -= kBand_px;
  draw_time_axis(canvas, axes, with_unit(said.time, "s"));
}

void draw_drive_legend(Canvas& canvas, Vector2 at, const Words& said) {
  const Colour colour = Colour::hex(0x4b535d);
  const Vector2 size{26, 14};
  for (const WordOf word : {&Words::active, &Words::suppressed, &Words::quiet}) {
    const std::array<std::array<Vector2, 2>, 1> box{std::array{at - Vector2{0, 11}, size}};
    if (word == &Words::active) canvas.rectangle(box[0][0], size, colour);
    if (word == &Words::suppressed) canvas.hatch(box, 5, {colour, 1.2, {}});
    canvas.rectangle(box[0][0], size, kEdge);
    canvas.text(at + Vector2{34, 0}, said.*word);
    at.x += 34 + widest(canvas, word) + 28;
  }
}

Picture bands_picture(const RobotView& robot, double duration_s, Language language) {
  const Words& said = words(language);
  double height_px = 78;
  for (const Coordination& coordination : robot.coordinations) height_px += height_of(coordination);
  std::string title = fmt::format("{}: {}", std::string_view(said.behaviours), robot.name);
  auto draw = [&robot, &said, duration_s, title](Canvas& canvas) {
    canvas.text({16, 26}, canvas.fitted(title, kPictureWidth_px - 40), Anchor::Start, {.size_px = 15, .bold = true});
    draw_drive_legend(canvas, {16, 54}, said);
    double top = 70;
    for (const Coordination& coordination : robot.coordinations) {
      draw_coordination(canvas, coordination, top, duration_s, said);
      top += height_of(coordination);
    }
  };
  return {file_stem("behaviours-" + robot.name),
          std::move(title),
          std::string(said.behaviours_about),
          kPictureWidth_px,
          height_px,
          std::move(draw)};
}

bool wants(const RunView& run) {
  return std::ranges::any_of(run.robots, [](const RobotView& robot) { return !robot.coordinations.empty(); });
}

std::vector<Picture> draw(const RunView& run, Language language) {
  std::vector<Picture> pictures;
  for (std::size_t i = 0; i < std::min(run.robots.size(), kMaxDrawnRobots); ++i)
    if (!run.robots[i].coordinations.empty())
      pictures.push_back(bands_picture(run.robots[i], run.duration_s, language));
  return pictures;
}

}  // namespace

extern const PictureKind behaviours_kind;
constinit const PictureKind behaviours_kind{
    .descriptor = {.component_class = ComponentClass::Picture,
                   .name = "Behaviours",
                   .summary = {"Who drove, who wanted to, who was quiet: one picture a robot that has coordinators.",
                               "Quién conducía, quién quería y quién callaba: una imagen por robot con coordinadores."},
                   .source = "ours"},
    .order = 30,
    .wants = wants,
    .draw = draw};

}  // namespace ganglion::plot
