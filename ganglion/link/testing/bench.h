#pragma once

#include <memory>

#include "ganglion/link/controller/remote_application.h"
#include "ganglion/link/testing/memory_line.h"
#include "ganglion/link/testing/notebook_robot.h"

namespace ganglion::link {

/// Tokens "token0", "token1"...
RobotEndConfig robot_config();

/// A robot, its end, and a line to it.
struct Bench {
  explicit Bench(Carrier carrier = Carrier::Stream, int robots = 1);
  /// None, and the error kept, where it cannot be.
  std::unique_ptr<RemoteApplication> connect(const RemoteConfig& config = {});
  NotebookRobot robot;
  RobotEnd end;
  std::unique_ptr<MemoryLine> own;
  MemoryLine* line = nullptr;
  std::string error;
};

/// Drives robots for so many ticks, or until they fail. Returns all that was sensed.
std::vector<double> drive(Application& application, int ticks);

}  // namespace ganglion::link
