#include "ganglion/module/testing/request_bench.h"

#include <algorithm>
#include <charconv>

#include "ganglion/base/expects.h"

namespace ganglion::testing {
namespace {

/// The size asked for in "name:3", if `entry` is about this port at all.
std::optional<int> wired_size(std::string_view entry, const PortDescriptor& port) {
  const std::size_t colon = entry.find(':');
  if (entry.substr(0, colon) != port.name) return std::nullopt;
  int size = std::max(port.size, 1);
  if (colon != std::string_view::npos) {
    const std::string_view digits = entry.substr(colon + 1);
    std::from_chars(digits.data(), digits.data() + digits.size(), size);
  }
  return size;
}

int size_of(const PortDescriptor& port, std::span<const std::string_view> wired) {
  if (wired.empty()) return std::max(port.size, 1);
  for (const std::string_view entry : wired) {
    if (const auto size = wired_size(entry, port)) return *size;
  }
  return 0;
}

}  // namespace

PortBlock::PortBlock(const Descriptor& descriptor, std::initializer_list<std::string_view> wired) {
  for (const PortDescriptor& port : descriptor.ports) {
    const bool asked = port.role == PortRole::Request;  // an input as well, but requests come through their slot
    const auto size = static_cast<std::size_t>(asked ? 0 : size_of(port, {wired.begin(), wired.size()}));
    if (is_input(descriptor.component_class, port.role)) {
      inputs_.push_back({port.name, std::vector<double>(size), 0});
    } else if (port.role == PortRole::Output) {
      results_.push_back({port.name, std::vector<double>(static_cast<std::size_t>(std::max(port.size, 1))), 0});
    } else if (port.role == PortRole::Appraisal) {
      appraisal_.assign(static_cast<std::size_t>(std::max(port.size, 1)), 0);
    }
  }
  for (const Port& port : inputs_) views_.push_back({port.values, {&port.age_s, port.values.empty() ? 0u : 1u}});
  for (Port& port : results_) outputs_.emplace_back(port.values);
}

void PortBlock::set(std::string_view port, std::initializer_list<double> values, double age_s) {
  Port& input = inputs_[input_index(port)];
  expects(values.size() == input.values.size());
  std::copy(values.begin(), values.end(), input.values.begin());
  input.age_s = age_s;
}

std::size_t PortBlock::input_index(std::string_view port) const {
  const auto found = std::find_if(inputs_.begin(), inputs_.end(), [&](const Port& p) { return p.name == port; });
  expects(found != inputs_.end());
  return static_cast<std::size_t>(found - inputs_.begin());
}

double PortBlock::output(std::string_view port) const {
  const auto found = std::find_if(results_.begin(), results_.end(), [&](const Port& p) { return p.name == port; });
  expects(found != results_.end());
  return found->values[0];
}

RequestBench::RequestBench(ActingModule& module, const Descriptor& descriptor,
                           std::initializer_list<std::string_view> wired, double step_s)
    : module_(&module), ports_(descriptor, wired), tick_{0, 0, step_s} {
  const auto has_role = [&](PortRole role) {
    return std::any_of(descriptor.ports.begin(), descriptor.ports.end(), [&](const auto& p) { return p.role == role; });
  };
  if (has_role(PortRole::Request)) joints_.request = &request_;
  for (const PortDescriptor& port : descriptor.ports) {
    if (port.role != PortRole::Feedback) continue;
    joints_.satisfied_by = ports_.input_index(port.name);
    joints_.comparison = Comparison::within(0, port.type == ValueType::Circular);
    break;
  }
  module.bind(ports_.links());
  module.join(joints_);
  module.grow();
}

void RequestBench::join_below(RequestSlot& below) {
  joints_.below = &below;
  module_->join(joints_);
}

void RequestBench::join_likes(std::span<const ReasonCode> likes) {
  joints_.likes = likes;
  module_->join(joints_);
}

const Command& RequestBench::tick(std::optional<double> cost) {
  ++tick_.number;
  tick_.time_s += tick_.step_s;
  module_->settle(cost);
  if (!module_->waits()) module_->cycle(tick_);
  module_->grow();
  return module_->command();
}

}  // namespace ganglion::testing
