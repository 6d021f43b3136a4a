#include <gtest/gtest.h>

#include <cmath>

#include "ganglion/link/wire/description.h"
#include "tests/clients/frames_for_robot.h"

// clients/c against docs/link.md, frame by frame.
namespace ganglion::link {
namespace {

Floats values_of(const wire::Sense& sense) { return {sense.values32().begin(), sense.values32().end()}; }

TEST(CRobot, GreetsWithATokenWhatItIsAndWhatItSenses) {
  CRobot robot;
  robot.sensed = {1.5F, kInf, kNan, 0.0F};
  wire::Hello hello;
  hello.set_major(1);
  hello.set_minor(3);
  hello.set_name("a controller with a name of some length, ganglion 0.1.0");
  hello.set_pace(wire::FREE_RUNNING);
  robot.say(hello);
  ASSERT_EQ(robot.next(), FrameKind::Hello);
  EXPECT_EQ(robot.in.hello.major(), 1u);
  EXPECT_EQ(robot.in.hello.token().size(), 8u);
  EXPECT_TRUE(robot.in.hello.floats());
  EXPECT_FALSE(robot.in.hello.resumed());
  ASSERT_EQ(robot.next(), FrameKind::Describe);
  ASSERT_EQ(robot.next(), FrameKind::Sense);
  EXPECT_EQ(robot.in.sense.tick(), 0u);
  EXPECT_EQ(robot.in.sense.time_ms(), 1000u);
  const Floats sensed = values_of(robot.in.sense);
  ASSERT_EQ(sensed.size(), 4u);
  EXPECT_EQ(sensed[0], 1.5F);
  EXPECT_EQ(sensed[1], kInf);
  EXPECT_TRUE(std::isnan(sensed[2]));
  EXPECT_EQ(sensed[3], 0.0F);
}

TEST(CRobot, DescribesItselfAsItsFileDoes) {
  CRobot robot;
  robot.greet(wire::FREE_RUNNING);
  EXPECT_TRUE(robot.in.describe.lock_step());
  EXPECT_TRUE(robot.in.describe.free_running());
  const auto description = read_description(robot.in.describe);
  ASSERT_TRUE(description) << description.error().what.en;
  EXPECT_EQ(description->name, "Bench robot");
  EXPECT_EQ(description->tick_s, 0.1);
  EXPECT_EQ(description->body->width_m, 0.2);
  ASSERT_EQ(description->sensations.size(), 3u);
  EXPECT_EQ(description->sensations[0].max, 3);
  EXPECT_EQ(description->mount(description->sensations[0].name)->pose.position.y, -0.1);
  EXPECT_NEAR(description->mount(description->sensations[0].name)->pose.yaw.deg(), 45, 1e-12);
  EXPECT_EQ(description->sensations[1].type, ValueType::Circular);
  EXPECT_EQ(description->sensations[1].period_s, 0.2);
  EXPECT_EQ(description->sensations[2].elements, (std::vector<std::string>{"x", "y"}));
  ASSERT_EQ(description->commands.size(), 2u);
  EXPECT_EQ(description->commands[0].elements[1].name, "right");
  EXPECT_EQ(description->commands[0].elements[1].max, 0.5);
  EXPECT_EQ(description->commands[0].elements[1].safe, 0.25);
  EXPECT_EQ(description->commands[1].elements[0].name, "horn");
  EXPECT_EQ(description->commands[1].elements[0].min, 0);
  EXPECT_EQ(description->commands[1].elements[0].max, 1);
}

TEST(CRobot, KeepsCommandsWithinTheirLimits) {
  CRobot robot;
  EXPECT_EQ(robot.done, kSafe);
  robot.greet(wire::FREE_RUNNING);
  robot.say(act(0, {0.5F, 0.125F, 1.0F}));
  EXPECT_EQ(robot.done, (Floats{0.5F, 0.125F, 1.0F}));
  robot.say(act(1, {7.0F, -1e30F, -0.5F}));
  EXPECT_EQ(robot.done, (Floats{1, 0, 0}));
  robot.say(act(2, {kNan, kInf, -kInf}));
  EXPECT_EQ(robot.done, kSafe);
}

TEST(CRobot, StopsByItselfWhenItsCommandsHaveRunOut) {
  const std::pair<std::uint32_t, std::uint32_t> kHeld_ms[] = {
      {200, 200}, {0, 300}, {60'000, 500}, {4'294'967'295, 500}};
  for (const auto& [ttl_ms, held_ms] : kHeld_ms) {
    CRobot robot;
    robot.now_ms = 4'294'967'200;  // the clock wraps
    robot.greet(wire::FREE_RUNNING);
    robot.say(act(0, {1, 0, 1}, ttl_ms));
    robot.now_ms += held_ms - 1;
    robot.poll();
    EXPECT_EQ(robot.done, (Floats{1, 0, 1})) << ttl_ms;
    ++robot.now_ms;
    robot.poll();
    EXPECT_EQ(robot.done, kSafe) << ttl_ms;
  }
}

TEST(CRobot, TakesTheShortestOfSeveralTimesToLive) {
  CRobot robot;
  robot.greet(wire::FREE_RUNNING);
  wire::Act message = act(0, {1, 0, 1}, 400);
  message.add_ttl_s(0.4);
  message.add_ttl_s(0.05);
  robot.say(message);
  robot.now_ms += 49;
  robot.poll();
  EXPECT_EQ(robot.done, (Floats{1, 0, 1}));
  ++robot.now_ms;
  robot.poll();
  EXPECT_EQ(robot.done, kSafe);
}

TEST(CRobot, TakesSafeValuesAtByeAndWhenAnotherSessionBegins) {
  CRobot robot;
  robot.greet(wire::FREE_RUNNING);
  robot.say(act(0, {1, 0, 1}));
  robot.say(wire::Bye());
  EXPECT_EQ(robot.done, kSafe);
  CRobot other;
  other.greet(wire::FREE_RUNNING);
  other.say(act(0, {1, 0, 1}));
  const std::string first = other.token;
  other.greet(wire::FREE_RUNNING);
  EXPECT_EQ(other.done, kSafe);
  EXPECT_NE(other.token, first);
}

TEST(CRobot, TellsWhatItSensesAtEveryTickOfItsOwn) {
  CRobot robot;
  robot.greet(wire::FREE_RUNNING);
  robot.now_ms += 99;
  robot.poll();
  EXPECT_EQ(robot.next(), FrameKind::Unknown);
  ++robot.now_ms;
  robot.poll();
  ASSERT_EQ(robot.next(), FrameKind::Sense);
  EXPECT_EQ(robot.in.sense.tick(), 1u);
  EXPECT_EQ(robot.in.sense.time_ms(), 1100u);
  robot.poll();
  EXPECT_EQ(robot.next(), FrameKind::Unknown);
}

TEST(CRobot, DropsCommandsThatAreNotNewerThanTheLast) {
  CRobot robot;
  robot.greet(wire::FREE_RUNNING);
  robot.say(act(5, {1, 0, 0}));
  robot.say(act(5, {0.5F, 0, 0}));
  robot.say(act(4, {0.5F, 0, 0}));
  EXPECT_EQ(robot.done, (Floats{1, 0, 0}));
  robot.say(act(6, {0.5F, 0, 0}));
  EXPECT_EQ(robot.done, (Floats{0.5F, 0, 0}));
}

TEST(CRobot, DoesEveryTickOfLockStepOnce) {
  CRobot robot;
  robot.greet(wire::LOCK_STEP);
  robot.say(step(0, 0));
  ASSERT_EQ(robot.next(), FrameKind::Sense);
  EXPECT_EQ(robot.in.sense.tick(), 1u);
  EXPECT_EQ(robot.in.sense.time_ms(), 100u);
  robot.say(step(0, 0));  // the answer was lost
  ASSERT_EQ(robot.next(), FrameKind::Sense);
  EXPECT_EQ(robot.in.sense.tick(), 1u);
  EXPECT_EQ(robot.steps_ms, (std::vector<std::uint32_t>{100}));
  robot.now_ms += 100'000;  // its time stands still meanwhile
  robot.poll();
  EXPECT_EQ(robot.next(), FrameKind::Unknown);
  EXPECT_EQ(robot.done, (Floats{0.5F, 0.5F, 0.5F}));
  robot.say(step(2, 0));
  ASSERT_EQ(robot.next(), FrameKind::Bye);
  EXPECT_EQ(robot.in.bye.code(), wire::BROKEN);
  EXPECT_EQ(robot.done, kSafe);
}

TEST(CRobot, StepsAsLongAsItIsAsked) {
  const std::pair<double, std::uint32_t> kSteps[] = {{0.1, 100},        {0.001, 1},  {1.6, 1600},      {0.0127, 13},
                                                     {3600, 3'600'000}, {0.0001, 1}, {59.999, 59'999}, {0.00049, 1}};
  for (const auto& [step_s, step_ms] : kSteps) {
    CRobot robot;
    robot.greet(wire::LOCK_STEP);
    robot.say(step(0, step_s, 4'000'000));
    EXPECT_EQ(robot.steps_ms, (std::vector<std::uint32_t>{step_ms})) << step_s;
  }
  for (const double step_s : {3602.0, -1.0, 1e300, std::nan(""), -std::nan(""), HUGE_VAL}) {
    CRobot robot;
    robot.greet(wire::LOCK_STEP);
    robot.say(step(0, step_s));
    EXPECT_EQ(robot.last(), FrameKind::Bye) << step_s;
    EXPECT_TRUE(robot.steps_ms.empty()) << step_s;
  }
}

TEST(CRobot, StopsWithinALongStep) {
  CRobot robot;
  robot.greet(wire::LOCK_STEP);
  robot.say(step(0, 1.6, 300));
  EXPECT_EQ(robot.steps_ms, (std::vector<std::uint32_t>{300, 1300}));
  EXPECT_EQ(robot.done, kSafe);
  ASSERT_EQ(robot.next(), FrameKind::Sense);
  EXPECT_EQ(robot.in.sense.time_ms(), 1600u);
}

TEST(CRobot, GoesOnWithASessionWhoseConnectionBroke) {
  CRobot robot;
  robot.greet(wire::FREE_RUNNING);
  robot.now_ms += 100;
  robot.poll();
  robot.say(act(1, {1, 0, 1}));
  robot.last();
  wire::Hello hello;
  hello.set_major(1);
  hello.set_pace(wire::FREE_RUNNING);
  hello.set_token(robot.token);
  robot.say(hello);
  ASSERT_EQ(robot.next(), FrameKind::Hello);
  EXPECT_TRUE(robot.in.hello.resumed());
  EXPECT_EQ(robot.in.hello.token(), robot.token);
  EXPECT_EQ(robot.in.hello.last_tick(), 1u);
  EXPECT_EQ(robot.next(), FrameKind::Describe);
  ASSERT_EQ(robot.next(), FrameKind::Sense);
  EXPECT_EQ(robot.in.sense.tick(), 1u);
  EXPECT_EQ(robot.done, (Floats{1, 0, 1}));
  for (const char* stranger : {"aaaaaaaa", "a", "aaaaaaaaaaaaaaaaaaaaaaaa"}) {
    hello.set_token(stranger);
    CRobot fresh;
    fresh.say(hello);
    ASSERT_EQ(fresh.next(), FrameKind::Bye);
    EXPECT_EQ(fresh.in.bye.code(), wire::NO_SESSION);
  }
}

TEST(CRobot, RefusesWhatItCannotDo) {
  const auto refused = [](const wire::Hello& hello) {
    CRobot robot(CRobot::Options{.can_lock_step = false});
    robot.say(hello);
    EXPECT_EQ(robot.next(), FrameKind::Bye);
    EXPECT_FALSE(robot.in.bye.reason().empty());
    EXPECT_EQ(robot.next(), FrameKind::Unknown);
    robot.say(act(0, {1, 1, 1}));
    EXPECT_EQ(robot.done, kSafe);
    return robot.in.bye.code();
  };
  wire::Hello hello;
  hello.set_pace(wire::FREE_RUNNING);
  hello.set_major(2);
  EXPECT_EQ(refused(hello), wire::VERSION);
  hello.set_major(1);
  hello.set_role(wire::WATCH);
  EXPECT_EQ(refused(hello), wire::TOO_MANY);
  hello.set_role(wire::COMMAND);
  hello.set_pace(wire::LOCK_STEP);
  EXPECT_EQ(refused(hello), wire::REFUSED);
}

TEST(CRobot, AnswersHeartbeatsAndEchoesResets) {
  CRobot robot;
  robot.greet(wire::LOCK_STEP);
  wire::Beat beat;
  beat.set_number(123'456);
  beat.set_time_s(17.5);
  robot.say(beat);
  ASSERT_EQ(robot.next(), FrameKind::Beat);
  EXPECT_EQ(robot.in.beat.number(), 123'456u);
  EXPECT_TRUE(robot.in.beat.answer());
  EXPECT_EQ(robot.in.beat.time_ms(), 1000u);
  beat.set_answer(true);
  robot.say(beat);
  EXPECT_EQ(robot.next(), FrameKind::Unknown);
  wire::Reset reset;
  reset.set_seed(std::numeric_limits<std::uint64_t>::max());
  reset.set_episode(3);
  robot.say(step(0, 0));
  ASSERT_EQ(robot.last(), FrameKind::Sense);
  EXPECT_EQ(robot.in.sense.tick(), 1u);
  robot.say(reset);
  ASSERT_EQ(robot.next(), FrameKind::Reset);
  EXPECT_EQ(robot.in.reset.seed(), reset.seed());
  EXPECT_EQ(robot.in.reset.episode(), 3u);
  ASSERT_EQ(robot.next(), FrameKind::Sense);
  EXPECT_EQ(robot.in.sense.tick(), 0u);
  EXPECT_EQ(robot.in.sense.time_ms(), 0u);
  EXPECT_EQ(robot.resets, 1);
}

TEST(CRobot, EndsASessionThatBreaksTheRules) {
  const auto ended = [](const wire::Act& message) {
    CRobot robot;
    robot.greet(wire::FREE_RUNNING);
    robot.say(act(0, {1, 0, 1}));
    robot.say(message);
    EXPECT_EQ(robot.last(), FrameKind::Bye);
    EXPECT_EQ(robot.in.bye.code(), wire::BROKEN);
    EXPECT_EQ(robot.done, kSafe);
    robot.say(act(9, {1, 0, 1}));
    EXPECT_EQ(robot.done, kSafe) << "it must be greeted anew";
  };
  ended(act(1, {1, 0}));
  ended(act(1, {1, 0, 1, 0}));
  ended(wire::Act());
  ended(act(1, {1, 0, 1, 1, 0, 1}));  // for two robots
}

TEST(CRobot, SendsFramesOfEveryLength) {
  for (int count = 1; count < 140; ++count) {
    for (const float value : {0.0F, 1.0F, 1.2345678F}) {  // zeros only, some, none
      CRobot robot(CRobot::Options{.sensations = count});
      robot.sensed.assign(static_cast<std::size_t>(count), value);
      robot.greet(wire::FREE_RUNNING);
      EXPECT_EQ(values_of(robot.in.sense), robot.sensed) << count;
    }
  }
}

}  // namespace
}  // namespace ganglion::link
