#include "ganglion/sim/sensor/audio_events/audio_events.h"

#include <cmath>

#include "ganglion/sim/robot/testing/stage.h"

namespace ganglion::sim {
namespace {

using testing::made;
using testing::Stage;

/// Chirps 3, 1, 2 at 0.5, 0.8 and 1.1 s, and again every 1.9 s.
const std::string kBeacon =
    "format = 1\nname = \"w\"\n[[beacon]]\nid = \"b\"\nx_m = 2\ny_m = 0\nword = [3, 1, 2]\nevent_s = 0.3\npause_s = 1\n"
    "start_s = 0.5\nsound_range_m = 4\n";

std::array<double, 2> read(Sensor& ear, const Scene& scene) {
  std::array<double, 2> values{};
  Draws draws(StreamId{2, 0, 0, 4}, scene.tick);
  ear.measure(scene, draws, values);
  return values;
}

/// What is heard at 0, 0.1, 0.2... s: "time:event" of all that is not silence.
std::string heard(Stage& stage, Sensor& ear, double until_s, Vector2 place = {0, 0}) {
  std::string text;
  EXPECT_TRUE(ear.reset(stage.at({}), Draws(StreamId{}, 0)));
  for (int n = 0; n * 0.1 <= until_s; ++n) {
    const double event = read(ear, stage.at({place, {}}, n * 0.1))[0];
    if (event > 0) text += fmt::format("{:.1f}:{} ", n * 0.1, event);
  }
  return text;
}

TEST(AudioEvents, HearsEachEventOfAWordOnce) {
  Stage stage(kBeacon);
  const auto ear = made(audio_events_kind);
  EXPECT_EQ(heard(stage, *ear, 3.15), "0.5:3 0.8:1 1.1:2 2.4:3 2.7:1 3.0:2 ");
}

TEST(AudioEvents, HearsNothingBeyondTheRange) {
  Stage stage(kBeacon);
  const auto ear = made(audio_events_kind);
  EXPECT_EQ(heard(stage, *ear, 3.15, {-2.01, 0}), "");
  EXPECT_NE(heard(stage, *ear, 3.15, {-1.99, 0}), "");
}

TEST(AudioEvents, TellsHowLoudAndFollowsTheLoudest) {
  Stage stage(kBeacon +
              "[[beacon]]\nid = \"c\"\nx_m = 0\ny_m = 1\nword = [7]\nevent_s = 0.3\npause_s = 1.6\nstart_s = 0.8\n"
              "sound_range_m = 4\n");
  const auto ear = made(audio_events_kind);
  EXPECT_EQ(heard(stage, *ear, 2.0), "0.5:3 0.8:7 1.1:2 ");  // the nearer one speaks at 0.8 s as well
  ASSERT_TRUE(ear->reset(stage.at({}), Draws(StreamId{}, 0)));
  EXPECT_NEAR(read(*ear, stage.at({}, 0.5))[1], 0.5, 1e-12);
  EXPECT_NEAR(read(*ear, stage.at({}, 0.8))[1], 0.75, 1e-12);
  EXPECT_EQ(read(*ear, stage.at({}, 0.9))[1], 0);
}

TEST(AudioEvents, MissesAndMistakesAsOftenAsStated) {
  Stage stage(
      "format = 1\nname = \"w\"\n[[beacon]]\nid = \"b\"\nx_m = 0\ny_m = 0\nword = [3]\nevent_s = 0.1\npause_s = 0\n");
  const auto ear = made(audio_events_kind, {{"missed", 0.1}, {"mistaken", 0.2}, {"alphabet", 5}});
  ASSERT_TRUE(ear->reset(stage.at({}), Draws(StreamId{}, 0)));
  const int count = 5000;
  std::array<int, 7> times{};
  for (int n = 0; n < count; ++n) {
    Scene scene = stage.at({}, n * 0.1);
    scene.tick = static_cast<std::uint32_t>(n);
    ++times.at(static_cast<std::size_t>(read(*ear, scene)[0]));
  }
  const auto expect_share = [&](int event, double share) {
    EXPECT_NEAR(times[static_cast<std::size_t>(event)], count * share, 4 * std::sqrt(count * share * (1 - share)))
        << event;
  };
  expect_share(0, 0.1);
  expect_share(3, 0.9 * 0.8);
  for (const int event : {1, 2, 4, 5}) expect_share(event, 0.9 * 0.2 / 4);
  EXPECT_EQ(times[6], 0);
}

}  // namespace
}  // namespace ganglion::sim
