#include "ganglion/link/controller/channel_map.h"

#include "ganglion/base/expects.h"

namespace ganglion::link {

ChannelMap::ChannelMap(const Description& file, const Description& robot) {
  for (const SensationChannel& channel : file.sensations) {
    const SensationChannel* theirs = robot.sensation(channel.name);
    expects(theirs != nullptr && theirs->size() == channel.size());
    const auto index = static_cast<std::size_t>(theirs - robot.sensations.data());
    ages_.push_back(index);
    for (int n = 0; n < channel.size(); ++n) {
      values_.push_back(static_cast<std::size_t>(robot.sensation_offset(index) + n));
    }
  }
  for (const CommandChannel& channel : file.commands) {
    const CommandChannel* theirs = robot.command(channel.name);
    expects(theirs != nullptr && theirs->elements.size() == channel.elements.size());
    const auto index = static_cast<std::size_t>(theirs - robot.commands.data());
    commands_.push_back(index);
    for (std::size_t n = 0; n < channel.elements.size(); ++n) {
      elements_.push_back(static_cast<std::size_t>(robot.command_offset(index)) + n);
    }
  }
}

void ChannelMap::to_file(const SenseFrame& robot, SenseFrame& file) const noexcept {
  file.tick = robot.tick;
  file.time_s = robot.time_s;
  file.cost = robot.cost;
  for (std::size_t n = 0; n < values_.size(); ++n) file.values[n] = robot.values[values_[n]];
  for (std::size_t n = 0; n < ages_.size(); ++n) file.ages_s[n] = robot.ages_s[ages_[n]];
}

void ChannelMap::to_robot(const ActFrame& file, ActFrame& robot) const noexcept {
  robot.tick = file.tick;
  for (std::size_t n = 0; n < elements_.size(); ++n) robot.values[elements_[n]] = file.values[n];
  for (std::size_t n = 0; n < commands_.size(); ++n) {
    robot.ttl_s[commands_[n]] = file.ttl_s[n];
    robot.origins[commands_[n]] = file.origins[n];
    robot.reasons[commands_[n]] = file.reasons[n];
  }
}

}  // namespace ganglion::link
