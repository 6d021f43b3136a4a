#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ganglion/graph/digest.h"
#include "ganglion/record/run_file.h"
#include "ganglion/sim/simulation/simulation.h"

namespace ganglion {

/// Something that was done to a run's world from outside, before a tick.
struct TimedIntervention {
  std::uint32_t tick = 0;
  sim::Intervention what;
};

/// Reaches into the world of a run that is on. See sim::Simulation::intervene(); fails with Unsupported where the
/// robots are at the other end of a link.
using Reach = std::function<Result<sim::Intervened>(const sim::Intervention&)>;

/// Topic and schema of interventions in a run file, and one of them as its JSON.
inline constexpr std::string_view kInterventionTopic = "/interventions";
inline constexpr std::string_view kInterventionSchema = "ganglion.Intervention";
std::string intervention_json(const TimedIntervention& one);
/// The same for people: "goal of robot 0 set at (1.25, 3.75)".
Sentence intervention_text(const TimedIntervention& one);
/// What was done to a recorded run, in order. Fails with Corrupt where it cannot be made out.
Result<std::vector<TimedIntervention>> interventions_of(const RunFile& run);

/// All that is done to one run's world: what was planned before it began, and what somebody does meanwhile.
class Interference {
 public:
  using Told = std::function<void(const TimedIntervention&)>;
  /// `simulation` null = the robots are not simulated here. `told` is called after each.
  Interference(sim::Simulation* simulation, std::vector<TimedIntervention> planned, Told told);

  /// The ticks before this one are over: does what was planned. Fails where that cannot be.
  Result<void> before(std::uint32_t tick);
  /// Does something before the tick that comes next.
  Result<sim::Intervened> reach(const sim::Intervention& what);

  std::size_t count() const noexcept { return count_; }
  /// Of all that was done and when; joins nothing until something is.
  const Digest& digest() const noexcept { return digest_; }

 private:
  sim::Simulation* simulation_;
  std::vector<TimedIntervention> planned_;
  std::size_t next_ = 0;  // of them
  Told told_;
  std::uint32_t tick_ = 0;
  std::size_t count_ = 0;
  Digest digest_;
};

}  // namespace ganglion
