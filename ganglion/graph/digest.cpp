#include "ganglion/graph/digest.h"

#include <fmt/format.h>

namespace ganglion {

std::size_t Digest::join(std::uint32_t robot, std::string_view component) {
  const std::uint64_t name = combine(robot, hash_name(component));
  parts_.push_back({robot, std::string(component), name});
  states_.push_back(name);
  return parts_.size() - 1;
}

std::uint64_t Digest::total() const noexcept {
  std::uint64_t sum = 0;  // addition does not care about order
  for (std::size_t i = 0; i < parts_.size(); ++i) sum += combine(parts_[i].name, states_[i]);
  return mix(sum);
}

std::vector<Digest::OfComponent> Digest::components() const {
  std::vector<OfComponent> result;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    result.push_back({parts_[i].robot, parts_[i].component, states_[i]});
  }
  return result;
}

std::string hex(std::uint64_t value) { return fmt::format("{:016x}", value); }

}  // namespace ganglion
