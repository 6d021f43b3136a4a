#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ganglion/module/acting_module.h"

namespace ganglion::testing {

/// Memory for the ports of one component, as the graph would give it: for tests of a kind without a graph.
class PortBlock {
 public:
  /// `wired` names the inputs that have a wire; "port:3" gives a port of open size three values. Empty = all inputs.
  PortBlock(const Descriptor& descriptor, std::initializer_list<std::string_view> wired = {});
  PortBlock(const PortBlock&) = delete;
  PortBlock& operator=(const PortBlock&) = delete;

  /// Puts a reading on an input port; missing readings are NaN or an infinity.
  void set(std::string_view port, std::initializer_list<double> values, double age_s = 0);
  double output(std::string_view port) const;
  std::span<const double> appraisal() const noexcept { return appraisal_; }
  Links links() const noexcept { return {views_, outputs_, const_cast<PortBlock*>(this)->appraisal_, StreamId{}}; }
  /// Index of a port among the inputs, or among the Outputs.
  std::size_t input_index(std::string_view port) const;

 private:
  struct Port {
    std::string_view name;
    std::vector<double> values;
    double age_s = 0;
  };
  std::vector<Port> inputs_;
  std::vector<Port> results_;
  std::vector<PortView> views_;
  std::vector<std::span<double>> outputs_;
  std::vector<double> appraisal_;
};

/// Drives one acting module through the ticks as the graph would: settle, cycle unless it waits, grow.
class RequestBench {
 public:
  RequestBench(ActingModule& module, const Descriptor& descriptor, std::initializer_list<std::string_view> wired = {},
               double step_s = 0.1);

  PortBlock& ports() noexcept { return ports_; }
  RequestSlot& request() noexcept { return request_; }
  /// Puts a slot below the module: its commands become requests there instead of going to the application.
  void join_below(RequestSlot& below);
  /// The common reasons that its own are cases of.
  void join_likes(std::span<const ReasonCode> likes);
  void ask(std::initializer_list<double> values) { request_.ask({values.begin(), values.size()}); }
  /// One tick; `cost` is that of the last command, absent in a first frame.
  const Command& tick(std::optional<double> cost);
  const Tick& now() const noexcept { return tick_; }

 private:
  ActingModule* module_;
  PortBlock ports_;
  RequestSlot request_;
  ActingLinks joints_;
  Tick tick_;
};

}  // namespace ganglion::testing
