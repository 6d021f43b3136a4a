#include "tests/clients/c_robot.h"

#include <gtest/gtest.h>

#include "bench_robot_describe.h"

namespace ganglion::link {
namespace {

#ifdef GANGLION_ROBOT_STREAM
constexpr Carrier kCarrier = Carrier::Stream;
#else
constexpr Carrier kCarrier = Carrier::Packets;
#endif

CRobot& self(void* user) { return *static_cast<CRobot*>(user); }

void write(void* user, const std::uint8_t* bytes, std::size_t count) {
  self(user).out.append(reinterpret_cast<const char*>(bytes), count);
}
void sense(void* user, float* values) { std::copy(self(user).sensed.begin(), self(user).sensed.end(), values); }
void act(void* user, const float* values) {
  self(user).done.assign(values, values + kCommands);
  ++self(user).acts;
}
void step(void* user, std::uint32_t step_ms) { self(user).steps_ms.push_back(step_ms); }
void reset(void* user) { ++self(user).resets; }
std::uint32_t random_number(void*) {
  static std::uint32_t state = 1;
  return state = state * 1664525 + 1013904223;
}

}  // namespace

CRobot::CRobot(Options options)
    : frame_(GANGLION_ROBOT_FRAME_BYTES(kCommands)),
      out_(8 + static_cast<std::size_t>(std::max<int>(options.sensations, kCommands)) + 1),
      writer_(kCarrier, Encoding::Binary),
      reader_(kCarrier) {
  sensed.resize(static_cast<std::size_t>(options.sensations), 1);
  using Out = GANGLION_ROBOT_OUT(5);
  static_assert(sizeof(Out) == sizeof(float) * (8 + 5 + 1));
  config_ = {.describe = kDescribe,
             .describe_bytes = sizeof kDescribe,
             .sensations = static_cast<std::uint16_t>(options.sensations),
             .commands = kCommands,
             .limits = kLimits,
             .tick_ms = kTickMs,
             .free_running = kFreeRunning != 0,
             .values = out_.data() + 8,
             .frame = frame_.data(),
             .frame_bytes = static_cast<std::uint16_t>(frame_.size()),
             .write = write,
             .sense = sense,
             .act = act,
             .random = random_number,
             .user = this,
             .step = options.can_lock_step ? step : nullptr,
             .reset = reset};
  ganglion_robot_init(&robot_, &config_);
  ganglion_robot_connected(&robot_);
}

void CRobot::written(const Result<void>& result) { EXPECT_TRUE(result) << result.error().what.en; }

void CRobot::receive(std::string_view bytes) {
  for (const char byte : bytes) {
    connected_ = connected_ && ganglion_robot_receive(&robot_, static_cast<std::uint8_t>(byte), now_ms);
  }
}

FrameKind CRobot::next() {
  reader_.feed(out);
  out.clear();
  const auto payload = reader_.next();
  EXPECT_TRUE(payload);
  EXPECT_EQ(reader_.take_damaged(), 0u);
  if (!payload || !*payload) return FrameKind::Unknown;
  const auto kind = decode(**payload, Encoding::Binary, in);
  EXPECT_TRUE(kind) << kind.error().what.en;
  return kind.value_or(FrameKind::Unknown);
}

FrameKind CRobot::last() {
  FrameKind kind = FrameKind::Unknown;
  for (FrameKind one = next(); one != FrameKind::Unknown; one = next()) kind = one;
  return kind;
}

void CRobot::greet(wire::Pace pace) {
  wire::Hello hello;
  hello.set_major(1);
  hello.set_pace(pace);
  say(hello);
  EXPECT_EQ(next(), FrameKind::Hello);
  token = in.hello.token();
  EXPECT_EQ(next(), FrameKind::Describe);
  EXPECT_EQ(next(), FrameKind::Sense);
  EXPECT_EQ(next(), FrameKind::Unknown);
}

}  // namespace ganglion::link
