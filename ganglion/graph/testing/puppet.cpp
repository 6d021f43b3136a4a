#include "ganglion/graph/testing/puppet.h"

#include <array>

#include "ganglion/graph/testing/described.h"

namespace ganglion::testing {
namespace {

enum Input : std::size_t { kAct, kValue, kTtl };
enum Output : std::size_t { kCycles, kAdaptations, kCharged, kGranted };

constexpr std::array kPorts = {
    port("act", PortRole::Feedback, "*"),
    port("value", PortRole::Feedback, "*", 0),
    optional(port("ttl_s", PortRole::Feedback, "*")),
    port("out", PortRole::Command, "*", 0),
    port("cycles", PortRole::Output),
    port("adaptations", PortRole::Output),
    port("charged", PortRole::Output),
    port("granted", PortRole::Output),
};

class Puppet final : public ActingModule {
 public:
  static Result<std::unique_ptr<ActingModule>> make(const Parameters&) { return std::make_unique<Puppet>(); }

 private:
  void internal_adaptation(const Feedback&, Cost cost) noexcept override {
    output(kAdaptations)[0] += 1;
    put(kCharged, cost.value);
  }
  Command internal_propagation(const Request&, const Feedback& feedback) noexcept override {
    output(kCycles)[0] += 1;
    put(kGranted, feedback.granted() ? 1 : 0);
    if (feedback.value(kAct) == 2) return Command::withdraw({ReasonCode::NoReading, 1, 2.5});
    if (feedback.value(kAct) != 1) return Command::inactive();
    Command command = Command::act(feedback[kValue].values);
    if (feedback[kTtl].wired()) command.ttl_s = feedback.value(kTtl);
    return command;
  }
};

}  // namespace

constinit const ActingModuleKind puppet_kind{
    {.component_class = ComponentClass::Acting, .name = "Puppet", .ports = kPorts}, Puppet::make};

}  // namespace ganglion::testing
