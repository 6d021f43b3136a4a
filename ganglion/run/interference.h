#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ganglion/application/application.h"
#include "ganglion/graph/digest.h"
#include "ganglion/record/run_file.h"

namespace ganglion {

/// Something that was done to a run's world from outside, before a tick.
struct TimedIntervention {
  std::uint32_t tick = 0;
  Intervention what;
};

/// Reaches into the world of a run that is on. See Application::intervene(); fails with Unsupported where the robots are
/// at the other end of a link.
using Reach = std::function<Result<Intervened>(const Intervention&)>;

/// Topic and schema of interventions in a run file, and one of them as its JSON: {"tick", "what": its name, the robot or
/// what it took hold of, its arguments}.
inline constexpr std::string_view kInterventionTopic = "/interventions";
inline constexpr std::string_view kInterventionSchema = "ganglion.Intervention";
std::string intervention_json(const InterventionDescriptor& descriptor, const TimedIntervention& one);
/// What was done to a recorded run, in order. Fails with Corrupt where it cannot be made out.
Result<std::vector<TimedIntervention>> interventions_of(const RunFile& run);

/// All that is done to one run's world: what was planned before it began, and what somebody does meanwhile.
class Interference {
 public:
  using Told = std::function<void(const InterventionDescriptor&, const TimedIntervention&)>;
  /// `application` null = it does not run in this program. `told` is called after each.
  Interference(Application* application, std::vector<TimedIntervention> planned, Told told);

  /// The ticks before this one are over: does what was planned. Fails where that cannot be.
  Result<void> before(std::uint32_t tick);
  /// Does something before the tick that comes next.
  Result<Intervened> reach(const Intervention& what);

  std::size_t count() const noexcept { return count_; }
  /// Of all that was done and when; joins nothing until something is.
  const Digest& digest() const noexcept { return digest_; }

 private:
  Application* application_;
  std::vector<TimedIntervention> planned_;
  std::size_t next_ = 0;  // of them
  Told told_;
  std::uint32_t tick_ = 0;
  std::size_t count_ = 0;
  Digest digest_;
};

}  // namespace ganglion
