// One acting module with nothing round it, as a microcontroller would have it: a thermostat that learns nothing, asked
// for 20 degrees, in a room that warms by a degree a tick while it heats. Ends with 0 once its request is satisfied.
#include "ganglion/module/tick/acting_cycle.h"

namespace {

class Thermostat final : public ganglion::ActingCycle {
  void internal_adaptation(const ganglion::Feedback&, ganglion::Cost) noexcept override {}
  ganglion::Command internal_propagation(const ganglion::Request& request,
                                         const ganglion::Feedback& feedback) noexcept override {
    return ganglion::Command::act({feedback.value(0) < request.values[0] ? 1.0 : 0.0});
  }
};

}  // namespace

int main() {
  double room = 15, age_s = 0;
  const ganglion::PortView view{{&room, 1}, {&age_s, 1}};
  ganglion::RequestSlot request;
  Thermostat thermostat;
  thermostat.see({&view, 1}, {});
  thermostat.join({.request = &request, .comparison = ganglion::Comparison::within(0.5)});
  const double wanted = 20;
  request.ask({&wanted, 1});
  for (std::uint32_t tick = 0; tick < 10; ++tick) {
    thermostat.settle(1.0);
    thermostat.cycle({tick, tick * 1.0, 1.0});
    room += thermostat.command().values[0];
  }
  const bool satisfied = request.status == ganglion::RequestStatus::Satisfied;
  return satisfied && room == 20 && request.cost == 5 ? 0 : 1;  // five degrees, a joule each
}
