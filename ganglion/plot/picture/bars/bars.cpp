#include <fmt/format.h>

#include <algorithm>

#include "ganglion/plot/canvas/axes.h"
#include "ganglion/plot/picture/picture_kind.h"
#include "ganglion/plot/picture/shapes.h"

namespace ganglion::plot {
namespace {

constexpr Text kAbout{"Bars as they were shown last.", "Barras como se mostraron por última vez."};
constexpr double kNames_px = 180, kBar_px = 26, kTop_px = 44;
constexpr std::size_t kMostBars = 80;

Picture picture_of(const RunView& run, const ExhibitTrack& track, const shown::Bars& bars, Language language) {
  const std::size_t count = std::min(bars.bars.size(), kMostBars);
  double low = 0, high = 0;
  for (const shown::Bar& bar : bars.bars) low = std::min(low, bar.value), high = std::max(high, bar.value);
  const double pad = high > low ? 0.12 * (high - low) : 1;  // room for the numbers
  const Axes axes{{kNames_px, kTop_px},
                  {kPictureWidth_px - kNames_px - 40, kBar_px * static_cast<double>(std::max<std::size_t>(1, count))},
                  {low < 0 ? low - pad : 0, 0},
                  {high > 0 ? high + pad : 0, 1}};
  std::string title = exhibit_title(run, track, language);
  auto draw = [&bars, axes, title, count, language](Canvas& canvas) {
    canvas.text({16, 26}, canvas.fitted(title, 900), Anchor::Start, {.size_px = 15, .bold = true});
    const double zero = axes.x_at(0);
    for (std::size_t i = 0; i < count; ++i) {
      const shown::Bar& bar = bars.bars[i];
      const double top = axes.corner_px.y + kBar_px * static_cast<double>(i), end = axes.x_at(bar.value);
      canvas.text({kNames_px - 10, top + 17}, canvas.fitted(bar.title.in(language), kNames_px - 20), Anchor::End);
      canvas.rectangle({std::min(zero, end), top + 4}, {std::max(0.6, std::abs(end - zero)), kBar_px - 8},
                       colour_of(bar.role));
      const bool left = bar.value < 0;
      canvas.text({left ? end - 6 : end + 6, top + 17}, fmt::format("{:.4g}", bar.value),
                  left ? Anchor::End : Anchor::Start, {.size_px = 11});
    }
    canvas.line({zero, axes.corner_px.y}, {zero, axes.bottom()}, {Colour::hex(0x5b6470), 1, {}});
    draw_time_axis(canvas, axes, axis_name(bars.up, language));
  };
  return {exhibit_id(track), std::move(title),   std::string(kAbout.in(language)),
          kPictureWidth_px,  axes.bottom() + 52, std::move(draw)};
}

bool wants(const RunView& run) { return !drawn_tracks(run, "bars").empty(); }

std::vector<Picture> draw(const RunView& run, Language language) {
  std::vector<Picture> pictures;
  for (const ExhibitTrack* track : drawn_tracks(run, "bars")) {
    const auto* bars = track->at<shown::Bars>(track->times_s.back());
    if (bars != nullptr) pictures.push_back(picture_of(run, *track, *bars, language));
  }
  return pictures;
}

}  // namespace

extern const PictureKind bars_kind;
constinit const PictureKind bars_kind{
    .descriptor = {.component_class = ComponentClass::Picture,
                   .name = "Bars",
                   .summary = {"Every set of bars that was shown.", "Cada conjunto de barras que se mostró."},
                   .source = "ours"},
    .order = 50,
    .wants = wants,
    .draw = draw};

}  // namespace ganglion::plot
