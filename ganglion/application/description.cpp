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

int Description::sensation_offset(std::size_t channel) const noexcept {
  int offset = 0;
  for (std::size_t i = 0; i < channel; ++i) offset += sensations[i].size();
  return offset;
}

int Description::command_offset(std::size_t channel) const noexcept {
  std::size_t offset = 0;
  for (std::size_t i = 0; i < channel; ++i) offset += commands[i].elements.size();
  return static_cast<int>(offset);
}

int Description::sensation_values() const noexcept { return sensation_offset(sensations.size()); }
int Description::command_values() const noexcept { return command_offset(commands.size()); }

const SensationChannel* Description::sensation(const std::string& channel_name) const noexcept {
  return find(sensations, channel_name);
}
const CommandChannel* Description::command(const std::string& channel_name) const noexcept {
  return find(commands, channel_name);
}

const Mount* Description::mount(std::string_view channel) const noexcept {
  if (!body) return nullptr;
  for (const Mount& mount : body->mounts) {
    const std::string_view device = mount.device;
    const bool inside = channel.starts_with(device) && channel.size() > device.size() && channel[device.size()] == '.';
    if (channel == device || inside) return &mount;
  }
  return nullptr;
}

}  // namespace ganglion
