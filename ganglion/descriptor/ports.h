#pragma once

#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/descriptor/descriptor.h"

namespace ganglion {

/// The ports of one component, as its parameters shape them; it owns their names.
class Ports {
 public:
  Ports() = default;
  Ports(Ports&&) noexcept = default;
  Ports& operator=(Ports&&) noexcept = default;
  Ports(const Ports&) = delete;  // names are pointed to
  Ports& operator=(const Ports&) = delete;

  /// Keeps a name for as long as these ports live.
  std::string_view own(std::string name) { return names_.emplace_back(std::move(name)); }
  void add(const PortDescriptor& port) { list_.push_back(port); }
  std::span<const PortDescriptor> list() const noexcept { return list_; }

 private:
  std::deque<std::string> names_;  // a deque never moves what it holds
  std::vector<PortDescriptor> list_;
};

}  // namespace ganglion
