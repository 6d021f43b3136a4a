// The robot in C, as its line brings it bytes and time. An input is a row of pieces, each behind a byte: 0 and a byte
// t, 10 t milliseconds pass; 1 and a byte, it arrives as it is; n > 1, a packet whose CRC is right holds the next n
// bytes. Whatever comes, what it does stays within its limits, and stops 500 ms after the last thing that came.
#include <cmath>
#include <vector>

#include "clients/c/ganglion_robot.h"
#include "fuzz/target.h"
#include "ganglion/link/wire/cobs.h"

namespace ganglion::fuzz {

constexpr ganglion_robot_limits kLimits[] = {{-1, 1, 0}, {0, 0.5F, 0.25F}};
constexpr std::uint8_t kDescribe[] = {1, 0};
constexpr std::uint32_t kMostTtl_ms = 500;

struct Body {
  float left = 0, right = 0;
  bool safe() const noexcept { return left == 0 && right == 0.25F; }
};

void act(void* user, const float* values) {
  must(values[0] >= -1 && values[0] <= 1 && values[1] >= 0 && values[1] <= 0.5F, "commands stay within their limits");
  *static_cast<Body*>(user) = {values[0], values[1]};
}

void run_input(std::string_view input) {
  Body body;
  std::vector<float> out(8 + 3 + 1);
  std::vector<std::uint8_t> frame(GANGLION_ROBOT_FRAME_BYTES(2));
  const ganglion_robot_config config = {
      .describe = kDescribe,
      .describe_bytes = sizeof kDescribe,
      .sensations = 3,
      .commands = 2,
      .limits = kLimits,
      .tick_ms = 100,
      .free_running = true,
      .values = out.data() + 8,
      .frame = frame.data(),
      .frame_bytes = static_cast<std::uint16_t>(frame.size()),
      .user = &body,
      .write = [](void*, const std::uint8_t* bytes,
                  std::size_t count) { must(bytes != nullptr && count < 1000, "what it says is short"); },
      .sense = [](void*, float* values) { values[0] = values[1] = values[2] = 1; },
      .act = act,
      .step = [](void*, std::uint32_t step_ms) { must(step_ms <= 3'600'000, "an hour at most"); },
      .reset = nullptr,
      .random = [](void*) { return std::uint32_t{0x12345678}; }};
  ganglion_robot robot;
  ganglion_robot_init(&robot, &config);
  std::uint32_t now_ms = 0;
  const auto hear = [&](std::string_view bytes) {
    for (const char byte : bytes) ganglion_robot_receive(&robot, static_cast<std::uint8_t>(byte), now_ms);
  };
  while (input.size() >= 2) {
    const auto head = static_cast<std::uint8_t>(input[0]);
    const auto first = static_cast<std::uint8_t>(input[1]);
    if (head == 0) now_ms += 10u * first;
    if (head == 1) hear(input.substr(1, 1));
    std::string packet;
    if (head > 1) link::append_packet(input.substr(1, head), packet);
    hear(packet);
    input.remove_prefix(std::min<std::size_t>(input.size(), 1u + std::max<std::size_t>(head, 1)));
    ganglion_robot_poll(&robot, now_ms);
  }
  now_ms += kMostTtl_ms;
  ganglion_robot_poll(&robot, now_ms);
  must(body.safe() || !robot.free_running, "it stops by itself");
}

}  // namespace ganglion::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ganglion::fuzz::run_input({reinterpret_cast<const char*>(data), size});
  return 0;
}
