#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "ganglion/link/net/address.h"
#include "ganglion/run/experiment.h"
#include "ganglion/studio/live/drawn_file.h"

namespace ganglion::studio {

/// What the page wants to run or to test, in files and keys.
struct Wanted {
  std::filesystem::path experiment;
  ExperimentFiles instead;
  std::vector<config::Override> overrides;
  LinkChoice link;                         ///< Where the page says that the robot is.
  std::shared_ptr<const DrawnFile> drawn;  ///< Null: the controller is the saved one.
};

/// Where the studio may look for a robot: tcp://HOST:PORT, serial+tcp://HOST:PORT, serial:///dev/tty... Fails with
/// BadParameter.
Result<link::Address> allowed_address(const std::string& text);

}  // namespace ganglion::studio
