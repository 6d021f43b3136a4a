#include "ganglion/link/fault/faulty_connection.h"

#include <gtest/gtest.h>

#include "ganglion/link/wire/cobs.h"

namespace ganglion::link {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// A binary frame: its length, then so many letters.
std::string frame(std::size_t bytes, char letter) {
  std::string out;
  append_frame(std::string(bytes, letter), Carrier::Stream, Encoding::Binary, out);
  return out;
}

FaultyConnection through(const std::string& faults, std::uint64_t seed = 1, Carrier carrier = Carrier::Stream) {
  const auto parsed = parse_line_faults(faults);
  EXPECT_TRUE(parsed) << parsed.error().text();
  return FaultyConnection(*parsed, seed, 0, carrier);
}

struct Arrived {
  double at_s;
  std::string bytes;
  bool end;
  friend bool operator==(const Arrived&, const Arrived&) = default;
};

/// Everything that is under way, each at the time it is due.
std::vector<Arrived> arrivals(FaultyConnection& connection, Way way) {
  std::vector<Arrived> all;
  while (connection.due_s() < kInf) {
    const double now_s = connection.due_s();
    while (auto one = connection.take(way, now_s)) all.push_back({now_s, one->bytes, one->end});
    while (connection.take(way == Way::ToRobot ? Way::ToController : Way::ToRobot, now_s)) continue;
  }
  return all;
}

std::string text_of(const std::vector<Arrived>& all) {
  std::string text;
  for (const Arrived& one : all) text += one.bytes;
  return text;
}

TEST(FaultyConnection, PassesEverythingAtOnceWithoutFaults) {
  FaultyConnection line = through("none");
  line.push(Way::ToRobot, frame(3, 'a') + frame(2, 'b').substr(0, 5), 1);
  line.push(Way::ToRobot, frame(2, 'b').substr(5), 2);
  line.finish(Way::ToRobot, 3);
  const std::vector<Arrived> expected = {{1, frame(3, 'a'), false}, {2, frame(2, 'b'), false}, {3, "", true}};
  EXPECT_EQ(arrivals(line, Way::ToRobot), expected);
}

TEST(FaultyConnection, PassesWhatIsNoLinkAsItComes) {
  FaultyConnection line = through("none");
  line.push(Way::ToRobot, "GET / HT", 1);
  line.push(Way::ToRobot, "TP/1.1", 2);
  EXPECT_EQ(arrivals(line, Way::ToRobot), (std::vector<Arrived>{{1, "GET / HT", false}, {2, "TP/1.1", false}}));
  FaultyConnection liar = through("none");
  const std::string announced = {'\0', '\x7f', '\0', '\0', 'x'};
  liar.push(Way::ToRobot, announced, 1);
  EXPECT_EQ(text_of(arrivals(liar, Way::ToRobot)), announced);
}

TEST(FaultyConnection, SendsTheRestOfAFrameWhenItsSenderCloses) {
  FaultyConnection line = through("none");
  line.push(Way::ToController, "{\"half\":", 1);
  EXPECT_EQ(line.due_s(), kInf);
  line.finish(Way::ToController, 2);
  EXPECT_EQ(text_of(arrivals(line, Way::ToController)), "{\"half\":");
}

TEST(FaultyConnection, DelaysEachFrameAndKeepsTheirOrder) {
  FaultyConnection line = through("delay=20ms; delay=100ms,until=1s");
  line.push(Way::ToRobot, frame(1, 'a'), 0.5);
  line.push(Way::ToRobot, frame(1, 'b'), 1);
  line.push(Way::ToController, frame(1, 'c'), 2);
  const std::vector<Arrived> expected = {{0.5 + 0.02 + 0.1, frame(1, 'a'), false}, {1.02, frame(1, 'b'), false}};
  EXPECT_EQ(arrivals(line, Way::ToRobot), expected);

  FaultyConnection jittery = through("jitter=1s");
  double before_s = 0;
  for (int n = 0; n < 50; ++n) jittery.push(Way::ToRobot, frame(1, static_cast<char>('a' + n % 26)), 0.1 * n);
  const auto all = arrivals(jittery, Way::ToRobot);
  ASSERT_EQ(all.size(), 50u);
  bool differ = false;
  for (int n = 0; n < 50; ++n) {
    const Arrived& one = all[static_cast<std::size_t>(n)];
    EXPECT_EQ(one.bytes, frame(1, static_cast<char>('a' + n % 26)));
    EXPECT_GE(one.at_s, std::max(before_s, 0.1 * n));
    EXPECT_LE(one.at_s, 0.1 * n + 1);
    differ = differ || one.at_s > 0.1 * n + 0.2;
    before_s = one.at_s;
  }
  EXPECT_TRUE(differ);
}

TEST(FaultyConnection, LosesTheShareOfFramesItIsTold) {
  FaultyConnection line = through("loss=20%,to=robot");
  for (int n = 0; n < 2000; ++n) {
    line.push(Way::ToRobot, frame(1, 'a'), n);
    line.push(Way::ToController, frame(1, 'b'), n);
  }
  // 400 expected, with a standard deviation of sqrt(2000 * 0.2 * 0.8) = 17.9: four of them to either side.
  EXPECT_NEAR(line.counts(Way::ToRobot).lost, 400, 72);
  EXPECT_EQ(line.counts(Way::ToController).lost, 0u);
  EXPECT_EQ(line.pending(Way::ToController), 2000u * 5);
}

TEST(FaultyConnection, DoublesSplitsAndMergesWithoutLosingAByte) {
  FaultyConnection doubled = through("duplicate=1");
  doubled.push(Way::ToRobot, frame(2, 'a'), 0);
  EXPECT_EQ(text_of(arrivals(doubled, Way::ToRobot)), frame(2, 'a') + frame(2, 'a'));

  FaultyConnection split = through("split=1");
  split.push(Way::ToRobot, frame(40, 'a'), 0);
  const auto pieces = arrivals(split, Way::ToRobot);
  EXPECT_GE(pieces.size(), 2u);
  EXPECT_LE(pieces.size(), 4u);
  EXPECT_EQ(pieces[1].at_s, kSplitGap_s);
  EXPECT_EQ(text_of(pieces), frame(40, 'a'));

  FaultyConnection merged = through("merge=1,until=1s");
  merged.push(Way::ToRobot, frame(2, 'a'), 0.98);
  merged.push(Way::ToRobot, frame(2, 'b'), 1);
  EXPECT_EQ(arrivals(merged, Way::ToRobot), (std::vector<Arrived>{{1, frame(2, 'a') + frame(2, 'b'), false}}));
  FaultyConnection alone = through("merge=1");
  alone.push(Way::ToRobot, frame(2, 'a'), 1);
  EXPECT_EQ(arrivals(alone, Way::ToRobot), (std::vector<Arrived>{{1 + kMergePatience_s, frame(2, 'a'), false}}));
}

TEST(FaultyConnection, ChangesTheShareOfBytesItIsToldByOneBit) {
  FaultyConnection line = through("corrupt=10%");
  const std::string sent = frame(10'000, 'a');
  line.push(Way::ToRobot, sent, 0);
  const std::string got = text_of(arrivals(line, Way::ToRobot));
  ASSERT_EQ(got.size(), sent.size());
  unsigned changed = 0;
  for (std::size_t n = 0; n < got.size(); ++n) {
    const unsigned difference = static_cast<unsigned char>(got[n] ^ sent[n]);
    if (difference == 0) continue;
    ++changed;
    EXPECT_EQ(difference & (difference - 1), 0u);
  }
  EXPECT_NEAR(changed, 1000, 120);  // standard deviation 30
  EXPECT_EQ(line.counts(Way::ToRobot).corrupted_bytes, changed);
}

TEST(FaultyConnection, HoldsEverythingWhileItIsFrozen) {
  FaultyConnection line = through("freeze,from=1s,until=3s; freeze,from=2s,until=4s; delay=500ms");
  line.push(Way::ToRobot, frame(1, 'a'), 0);
  line.push(Way::ToRobot, frame(1, 'b'), 0.75);
  line.push(Way::ToRobot, frame(1, 'c'), 3);
  line.finish(Way::ToRobot, 3.25);
  const auto all = arrivals(line, Way::ToRobot);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].at_s, 0.5);
  EXPECT_EQ(all[1].at_s, 4);
  EXPECT_EQ(all[2].at_s, 4);
  EXPECT_TRUE(all[3].end);
}

TEST(FaultyConnection, TellsNobodyWhileItIsMute) {
  FaultyConnection line = through("mute,to=robot,until=2s");
  line.push(Way::ToRobot, frame(1, 'a'), 1);
  line.push(Way::ToController, frame(1, 'b'), 1);
  line.finish(Way::ToRobot, 1.5);
  EXPECT_EQ(line.counts(Way::ToRobot).lost, 1u);
  EXPECT_EQ(line.pending(Way::ToController), 5u);
  EXPECT_TRUE(arrivals(line, Way::ToRobot).empty());
}

TEST(FaultyConnection, EndsWithinAFrameInOrderOrAtOnce) {
  FaultyConnection ended = through("fin=1,from=1s; delay=1s");
  ended.push(Way::ToController, frame(3, 'x'), 0.9);
  ended.push(Way::ToRobot, frame(3, 'a'), 0.5);
  ended.push(Way::ToRobot, frame(100, 'b'), 1);
  ended.push(Way::ToRobot, frame(3, 'c'), 1.1);
  FaultyConnection copy = ended;
  const auto all = arrivals(ended, Way::ToRobot);
  const std::string got = text_of(all), whole = frame(3, 'a') + frame(100, 'b');
  EXPECT_GE(got.size(), frame(3, 'a').size());
  EXPECT_LT(got.size(), whole.size());
  EXPECT_TRUE(whole.starts_with(got));
  EXPECT_TRUE(all.back().end);
  EXPECT_EQ(text_of(arrivals(copy, Way::ToController)), frame(3, 'x'));  // what was under way arrives
  EXPECT_FALSE(ended.reset());

  FaultyConnection cut = through("rst=1,from=1s; delay=1s");
  cut.push(Way::ToController, frame(3, 'x'), 0.9);
  cut.push(Way::ToRobot, frame(3, 'b'), 1);
  EXPECT_TRUE(cut.reset());
  EXPECT_EQ(cut.due_s(), kInf);
  EXPECT_EQ(cut.pending(Way::ToController), 0u);
}

TEST(FaultyConnection, StrikesTheSameFramesHoweverTheirBytesCome) {
  const std::string all = frame(3, 'a') + frame(9, 'b') + frame(1, 'c') + frame(30, 'd');
  std::string in_one;
  for (const std::size_t piece : {all.size(), std::size_t{1}, std::size_t{7}}) {
    FaultyConnection line = through("loss=50%,corrupt=5%", 5);
    for (std::size_t at = 0; at < all.size(); at += piece) line.push(Way::ToRobot, all.substr(at, piece), 1);
    const std::string got = text_of(arrivals(line, Way::ToRobot));
    if (in_one.empty()) in_one = got;
    EXPECT_EQ(got, in_one);
  }
}

TEST(FaultyConnection, CutsPacketsAtTheirEnds) {
  std::string packets;
  append_packet("one", packets);
  append_packet(std::string(3, '\0'), packets);
  FaultyConnection line = through("duplicate=1", 1, Carrier::Packets);
  line.push(Way::ToRobot, packets, 0);
  EXPECT_EQ(line.counts(Way::ToRobot).frames, 2u);
  EXPECT_EQ(line.counts(Way::ToRobot).text().en, "2 frames, 2 duplicated");
  EXPECT_EQ(line.counts(Way::ToRobot).text().es, "2 tramas, duplicadas: 2");
}

}  // namespace
}  // namespace ganglion::link
