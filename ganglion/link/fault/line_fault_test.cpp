#include "ganglion/link/fault/line_fault.h"

#include <gtest/gtest.h>

namespace ganglion::link {
namespace {

TEST(LineFaults, AreReadAsPeopleWriteThem) {
  const auto faults = parse_line_faults(
      "delay=20ms, jitter = 5ms,loss=1%,duplicate=0.25; freeze,from=4s,until=0.1min;mute,to=robot,from=1.5s");
  ASSERT_TRUE(faults) << faults.error().text();
  ASSERT_EQ(faults->size(), 3u);
  const LineFault& first = faults->front();
  EXPECT_EQ(first.delay_s, 0.02);
  EXPECT_EQ(first.jitter_s, 0.005);
  EXPECT_EQ(first.loss, 0.01);
  EXPECT_EQ(first.duplicate, 0.25);
  EXPECT_TRUE(first.to_robot && first.to_controller);
  EXPECT_EQ(first.until_s, std::numeric_limits<double>::infinity());
  EXPECT_TRUE((*faults)[1].freeze);
  EXPECT_EQ((*faults)[1].from_s, 4);
  EXPECT_EQ((*faults)[1].until_s, 6);
  EXPECT_TRUE((*faults)[2].mute && (*faults)[2].to_robot);
  EXPECT_FALSE((*faults)[2].to_controller);
}

TEST(LineFaults, MayBeNone) {
  for (const char* text : {"", " ", "none"}) {
    const auto faults = parse_line_faults(text);
    ASSERT_TRUE(faults);
    EXPECT_TRUE(faults->empty());
  }
}

TEST(LineFaults, AreRefusedAtTheirColumn) {
  struct Case {
    const char* text;
    const char* message;
  };
  for (const Case& one : {
           Case{"delay=20ms,los=0.1", "--faults:1:12: \"los\" is no fault of a line; did you mean \"loss\"?"},
           Case{"loss=1.5", "--faults:1:1: loss=1.5: must be a share from 0 to 1, or 0% to 100%"},
           Case{"loss", "--faults:1:1: loss=: must be a share from 0 to 1, or 0% to 100%"},
           Case{"mute; delay=20", "--faults:1:7: delay=20: must be a time from 0s to 60s, as in 20ms, 1.5s, 2min"},
           Case{"delay=-1s", "--faults:1:1: delay=-1s: must be a time from 0s to 60s, as in 20ms, 1.5s, 2min"},
           Case{"delay=nans", "--faults:1:1: delay=nans: must be a time from 0s to 60s, as in 20ms, 1.5s, 2min"},
           Case{"mute=1", "--faults:1:1: mute stands alone, without a value"},
           Case{"mute,to=left", "--faults:1:6: to=left: must be robot, controller or both"},
           Case{"freeze,from=4s", "--faults:1:1: freeze needs an end, as in freeze,from=4s,until=6s"},
           Case{"mute,from=4s,until=4s", "--faults:1:1: from=4s must lie before until=4s"},
       }) {
    const auto faults = parse_line_faults(one.text);
    ASSERT_FALSE(faults) << one.text;
    EXPECT_EQ(faults.error().text(), one.message);
  }
  EXPECT_EQ(parse_line_faults("los=0.1").error().text(Language::Spanish),
            "--faults:1:1: \"los\" no es un fallo de una línea; ¿quiso decir \"loss\"?");
}

TEST(LineFaults, AreDrawnFromASeedAndSayThemselvesAgain) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const LineFaults drawn = drawn_line_faults(seed, Hardness::Any);
    EXPECT_EQ(drawn, drawn_line_faults(seed, Hardness::Any));
    const auto read = parse_line_faults(text_of(drawn));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(*read, drawn) << text_of(drawn);
  }
  EXPECT_NE(text_of(drawn_line_faults(1, Hardness::Any)), text_of(drawn_line_faults(2, Hardness::Any)));
}

}  // namespace
}  // namespace ganglion::link
