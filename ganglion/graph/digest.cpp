#include "ganglion/graph/digest.h"

#include <fmt/format.h>

namespace ganglion {

std::size_t Digest::join(std::uint32_t robot, std::string_view component) {
  const std::uint64_t name = combine(robot, hash_name(component));
  parts_.push_back({robot, std::string(component), name, name});
  return parts_.size() - 1;
}

void Digest::add(std::size_t component, std::uint32_t tick, std::span<const double> values) noexcept {
  std::uint64_t state = combine(parts_[component].state, tick);
  for (const double value : values) state = (state ^ canonical_bits(value)) * 0x9fb21c651e98df25u + (state >> 29);
  parts_[component].state = state;
}

std::uint64_t Digest::total() const noexcept {
  std::uint64_t sum = 0;  // addition does not care about order
  for (const Part& part : parts_) sum += combine(part.name, part.state);
  return mix(sum);
}

std::vector<Digest::OfComponent> Digest::components() const {
  std::vector<OfComponent> result;
  for (const Part& part : parts_) result.push_back({part.robot, part.component, part.state});
  return result;
}

std::string hex(std::uint64_t value) { return fmt::format("{:016x}", value); }

}  // namespace ganglion
