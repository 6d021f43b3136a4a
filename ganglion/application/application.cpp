#include "ganglion/application/application.h"

#include <limits>

#include "ganglion/base/hash.h"

namespace ganglion {

Result<Intervened> Application::intervene(const Intervention& what) {
  return fail(ErrorCode::Unsupported, {"\"{}\" cannot be done to {}", "no se puede hacer \"{}\" a {}"}, what.name,
              description().name);
}

SenseFrame make_sense_frame(const Description& description) {
  SenseFrame frame;
  frame.values.assign(static_cast<std::size_t>(description.sensation_values()),
                      std::numeric_limits<double>::quiet_NaN());
  frame.ages_s.assign(description.sensations.size(), std::numeric_limits<double>::infinity());
  return frame;
}

ActFrame make_act_frame(const Description& description) {
  ActFrame frame;
  for (const CommandChannel& channel : description.commands) {
    for (const CommandElement& element : channel.elements) frame.values.push_back(element.safe);
  }
  const std::size_t channels = description.commands.size();
  frame.origins.assign(channels, CommandOrigin::Safe);
  frame.ttl_s.assign(channels, 0.3);
  frame.reasons.assign(channels, 0);
  return frame;
}

void make_canonical(SenseFrame& frame) noexcept {
  frame.time_s = canonical(frame.time_s);
  if (frame.cost) frame.cost = canonical(*frame.cost);
  for (double& value : frame.values) value = canonical(value);
  for (double& age_s : frame.ages_s) age_s = canonical(age_s);
}

void make_canonical(ActFrame& frame) noexcept {
  for (double& value : frame.values) value = canonical(value);
}

}  // namespace ganglion
