#include "ganglion/link/testing/bench.h"

#include "ganglion/base/expects.h"

namespace ganglion::link {

RobotEndConfig robot_config() {
  RobotEndConfig config;
  config.token = [n = 0]() mutable { return fmt::format("token{}", n++); };
  return config;
}

Bench::Bench(Carrier carrier, int robots) : robot(robots), end(robot, robot_config()) {
  expects(robot.reset(1, 0).has_value());
  own = std::make_unique<MemoryLine>(end, carrier);
  line = own.get();
}

std::unique_ptr<RemoteApplication> Bench::connect(const RemoteConfig& config) {
  auto made = RemoteApplication::connect(std::move(own), robot.description(), robot.robots(), config);
  if (!made) error = made.error().what.en;
  return made ? std::move(*made) : nullptr;
}

std::vector<double> drive(Application& application, int ticks) {
  std::vector<double> sensed;
  if (!application.reset(7, 0)) return sensed;
  std::vector<SenseFrame> sense(static_cast<std::size_t>(application.robots()),
                                make_sense_frame(application.description()));
  std::vector<ActFrame> act(sense.size(), make_act_frame(application.description()));
  for (int tick = 0; tick < ticks && application.failure() == nullptr; ++tick) {
    application.sense(sense);
    for (std::size_t n = 0; n < sense.size(); ++n) {
      make_canonical(sense[n]);
      decide(sense[n], act[n]);
      sensed.insert(sensed.end(), sense[n].values.begin(), sense[n].values.end());
      sensed.insert(sensed.end(), sense[n].ages_s.begin(), sense[n].ages_s.end());
      sensed.push_back(sense[n].cost.value_or(-1));
      sensed.push_back(sense[n].time_s);
    }
    application.step(act, 0.1);
  }
  return sensed;
}

}  // namespace ganglion::link
