#include "ganglion/application/description.h"

namespace ganglion {
namespace {

template <class Channel>
const Channel* find(const std::vector<Channel>& channels, const std::string& name) noexcept {
  for (const Channel& channel : channels) {
    if (channel.name == name) return &channel;
  }
  return nullptr;
}

}  // namespace

int RobotDescription::sensation_offset(std::size_t channel) const noexcept {
  int offset = 0;
  for (std::size_t i = 0; i < channel; ++i) offset += sensations[i].size();
  return offset;
}

int RobotDescription::command_offset(std::size_t channel) const noexcept {
  std::size_t offset = 0;
  for (std::size_t i = 0; i < channel; ++i) offset += commands[i].elements.size();
  return static_cast<int>(offset);
}

int RobotDescription::sensation_values() const noexcept { return sensation_offset(sensations.size()); }
int RobotDescription::command_values() const noexcept { return command_offset(commands.size()); }

const SensationChannel* RobotDescription::sensation(const std::string& channel_name) const noexcept {
  return find(sensations, channel_name);
}
const CommandChannel* RobotDescription::command(const std::string& channel_name) const noexcept {
  return find(commands, channel_name);
}

}  // namespace ganglion
