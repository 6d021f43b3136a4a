#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/hash.h"

namespace ganglion {

/// A fingerprint of every deterministic signal of a run: equal bits give equal digests, one bit more does not. Kept for
/// each component apart, so that an unrelated component added to a controller leaves the others' digests as they were.
class Digest {
 public:
  /// A component takes part under its name; returns its index for add().
  std::size_t join(std::uint32_t robot, std::string_view component);
  /// Values of one component at one tick, in a fixed order. Allocates nothing.
  void add(std::size_t component, std::uint32_t tick, std::span<const double> values) noexcept {
    std::uint64_t state = combine(states_[component], tick);
    for (const double value : values) state = (state ^ canonical_bits(value)) * 0x9fb21c651e98df25u + (state >> 29);
    states_[component] = state;
  }
  std::uint64_t of(std::size_t component) const noexcept { return states_[component]; }
  /// Independent of the order in which components joined.
  std::uint64_t total() const noexcept;

  /// The digest of one component, which two runs may share though the rest of them differs.
  struct OfComponent {
    std::uint32_t robot = 0;
    std::string component;
    std::uint64_t value = 0;
  };
  /// In the order in which they joined.
  std::vector<OfComponent> components() const;

 private:
  struct Part {
    std::uint32_t robot;
    std::string component;
    std::uint64_t name;
  };
  std::vector<Part> parts_;
  std::vector<std::uint64_t> states_;  // of each part; side by side, since every tick goes through all of them
};

/// 16 hexadecimal digits.
std::string hex(std::uint64_t value);

}  // namespace ganglion
