#pragma once

#include <vector>

#include "ganglion/application/application.h"

namespace ganglion::link {

/// From the frames of a robot as it describes itself to those of the file a controller was drawn for, by name. What the
/// robot offers besides is left out; what the file does not command takes its safe value.
class ChannelMap {
 public:
  /// Every channel of `file` is in `robot`, with as many elements.
  ChannelMap(const Description& file, const Description& robot);
  void to_file(const SenseFrame& robot, SenseFrame& file) const noexcept;
  void to_robot(const ActFrame& file, ActFrame& robot) const noexcept;

 private:
  std::vector<std::size_t> values_, ages_;  // where each of the file's is found in the robot's
  std::vector<std::size_t> commands_, elements_;
};

}  // namespace ganglion::link
