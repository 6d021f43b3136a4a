#pragma once

#include <gtest/gtest.h>

#include "ganglion/sim/drive/ackermann/ackermann.h"
#include "ganglion/sim/drive/differential/differential.h"
#include "ganglion/sim/drive/stepper/stepper.h"
#include "ganglion/sim/drive/tracked/tracked.h"
#include "ganglion/sim/robot/testing/stage.h"
#include "ganglion/sim/sensor/audio_events/audio_events.h"
#include "ganglion/sim/sensor/battery/battery.h"
#include "ganglion/sim/sensor/bumper/bumper.h"
#include "ganglion/sim/sensor/cmps03/cmps03.h"
#include "ganglion/sim/sensor/compass/compass.h"
#include "ganglion/sim/sensor/dinsmore_compass/dinsmore_compass.h"
#include "ganglion/sim/sensor/encoders/encoders.h"
#include "ganglion/sim/sensor/gps/gps.h"
#include "ganglion/sim/sensor/pixel_matrix/pixel_matrix.h"
#include "ganglion/sim/sensor/position/position.h"
#include "ganglion/sim/sensor/range/range.h"
#include "ganglion/sim/sensor/sonar/sonar.h"
#include "ganglion/sim/sensor/thermometer/thermometer.h"
#include "ganglion/sim/sensor/tilt/tilt.h"
#include "ganglion/sim/simulation/simulation.h"
#include "ganglion/task/go_to/go_to.h"
#include "ganglion/task/tasked_application.h"

namespace ganglion::sim::testing {

inline constexpr std::array kDrives = {&ackermann_kind, &differential_kind, &stepper_kind, &tracked_kind};
inline constexpr std::array kSensors = {
    &audio_events_kind, &battery_kind, &bumper_kind,       &cmps03_kind,   &compass_kind, &dinsmore_compass_kind,
    &encoders_kind,     &gps_kind,     &pixel_matrix_kind, &position_kind, &range_kind,   &sonar_kind,
    &thermometer_kind,  &tilt_kind};
inline constexpr std::array kTasks = {&go_to_kind};
inline constexpr SimKinds kKinds{kDrives, kSensors, kTasks};

/// A square of 10 m.
inline constexpr std::string_view kRoom =
    "format = 1\nname = \"room\"\n[[wall]]\npoints = [[0, 0], [10, 0], [10, 10], [0, 10]]\nclosed = true\n";

/// A round robot of 0.1 m with 1 m/s tracks, further lines appended.
inline std::shared_ptr<const RobotModel> robot_of(const std::string& more) {
  Problems problems;
  auto model = parse_robot("format = 1\nname = \"r\"\n[body]\nlength_m = 0.2\nwidth_m = 0.2\nradius_m = 0.1\n" + more,
                           "robot.toml", kKinds, problems);
  EXPECT_TRUE(model) << problems.text();
  return model;
}
inline const std::string kFast = "[drive]\nkind = \"Differential\"\nfull_scale_mps = 1\ntrack_m = 0.2\n";

/// A simulation with the tasks of its robots, and its frames.
class Trial {
 public:
  Trial(std::string_view world, const std::string& robot, SpawnRule spawn, int robots = 1)
      : Trial(ground_of(world), robot_of(robot), std::move(spawn), robots) {}
  Trial(std::shared_ptr<const Ground> ground, std::shared_ptr<const RobotModel> model, SpawnRule spawn, int robots) {
    auto made = Simulation::make({std::move(ground), model, robots, std::move(spawn)});
    EXPECT_TRUE(made) << made.error().what.en;
    simulation = made->get();
    auto tasked = TaskedApplication::make(std::move(*made), model->tasked, model->tasks);
    EXPECT_TRUE(tasked) << tasked.error().what.en;
    application = std::move(*tasked);
    for (int i = 0; i < robots; ++i) {
      senses.push_back(make_sense_frame(application->description()));
      acts.push_back(make_act_frame(application->description()));
      acts.back().ttl_s.assign(acts.back().ttl_s.size(), 1e9);
    }
    reset(1, 0);
  }
  void reset(std::uint64_t seed, std::uint32_t episode) {
    const auto ready = application->reset(seed, episode);
    EXPECT_TRUE(ready) << ready.error().what.en;
    application->sense(senses);
  }
  /// The same command for all robots, for a number of steps.
  void go(std::initializer_list<double> values, double step_s, int steps = 1) {
    for (ActFrame& act : acts) act.values = values;
    for (int n = 0; n < steps; ++n) {
      application->step(acts, step_s);
      application->sense(senses);
    }
  }
  const Truth& truth(int robot = 0) const { return simulation->truth(robot); }
  /// The first value of a channel.
  double value(const std::string& channel, int robot = 0) const {
    return senses[static_cast<std::size_t>(robot)].values[static_cast<std::size_t>(offset(channel))];
  }
  double age_s(const std::string& channel) const { return senses[0].ages_s[index(channel)]; }

  std::unique_ptr<Application> application;
  Simulation* simulation = nullptr;  // of application
  std::vector<SenseFrame> senses;
  std::vector<ActFrame> acts;

 private:
  std::size_t index(const std::string& channel) const {
    const auto& sensations = application->description().sensations;
    for (std::size_t i = 0; i < sensations.size(); ++i) {
      if (sensations[i].name == channel) return i;
    }
    ADD_FAILURE() << "no channel " << channel;
    return 0;
  }
  int offset(const std::string& channel) const { return application->description().sensation_offset(index(channel)); }
};

inline SpawnRule at(double x_m, double y_m, double yaw_deg = 0) {
  return SpawnPoses{{{{x_m, y_m}, Angle::from_deg(yaw_deg)}}};
}

}  // namespace ganglion::sim::testing
