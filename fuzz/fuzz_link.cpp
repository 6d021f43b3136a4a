// The robot link, from both ends: bytes for a robot from whoever connects, and for a controller from what says it is a
// robot. Whatever comes, commands stay within their limits, no tick is skipped, and what is kept for the other side
// stays small.
#include <cmath>

#include "fuzz/target.h"
#include "ganglion/link/testing/bench.h"

namespace ganglion::fuzz {

constexpr std::size_t kPiece = 61;
constexpr std::size_t kMostKept = std::size_t{4} << 20;

void feed_robot(std::string_view input, link::Carrier carrier) {
  link::NotebookRobot robot(2);
  robot.stepping = [](const ActFrame& frame) {
    for (const double value : frame.values) must(std::fabs(value) <= 1, "commands stay within their limits");
    for (const double ttl_s : frame.ttl_s) must(ttl_s >= 0, "a time to live is none below zero");
  };
  link::RobotEnd end(robot, nullptr, link::robot_config());
  const auto peer = end.open(carrier, "fuzzer", 0);
  double now_s = 0;
  while (!input.empty() && !end.gone(peer)) {
    end.receive(peer, input.substr(0, kPiece), now_s);
    input.remove_prefix(std::min(kPiece, input.size()));
    now_s += 0.01;
    end.poll(now_s);
    must(end.outgoing(peer).size() <= kMostKept, "who does not read is not written to for ever");
    must(std::isfinite(now_s) && end.due_s() > now_s - 1, "deadlines lie ahead");
  }
  for (std::size_t tick = 1; tick < robot.done().size(); ++tick) {
    must(robot.done()[tick].tick == robot.done()[tick - 1].tick + 1 || robot.done()[tick].tick == 0,
         "ticks are in order");
  }
}

void feed_controller(std::string_view input, link::Carrier carrier) {
  link::ControllerEnd end({.carrier = carrier});
  end.greet(0);
  end.connected(0);
  const link::NotebookRobot robot;
  std::vector<SenseFrame> sense = {make_sense_frame(robot.description())};
  const std::vector<ActFrame> act = {make_act_frame(robot.description())};
  double now_s = 0;
  while (!input.empty() && !end.failure()) {
    end.receive(input.substr(0, kPiece), now_s);
    input.remove_prefix(std::min(kPiece, input.size()));
    now_s += 0.01;
    if (!end.failure() && end.done()) {
      static_cast<void>(link::read_description(end.describe()));
      static_cast<void>(link::read_senses(end.sense(), sense));
      end.act(act, 0.1, now_s);
    }
    end.poll(now_s);
    if (end.wants_connection()) end.connected(now_s);
    end.outgoing().clear();
  }
}

void run_input(std::string_view input) {
  const int chosen = choice(input, 4);
  const link::Carrier carrier = chosen % 2 == 0 ? link::Carrier::Stream : link::Carrier::Packets;
  if (chosen < 2) {
    feed_robot(input, carrier);
  } else {
    feed_controller(input, carrier);
  }
}

}  // namespace ganglion::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ganglion::fuzz::run_input({reinterpret_cast<const char*>(data), size});
  return 0;
}
