#include <algorithm>
#include <array>

#include "ganglion/base/text.h"
#include "ganglion/sim/simulation/simulation.h"

namespace ganglion::sim {

std::span<const InterventionDescriptor> Simulation::interventions() const noexcept {
  static constexpr std::array<InterventionArgument, 2> kPoint = {{{"x_m", "m"}, {"y_m", "m"}}};
  static constexpr std::array kList = {InterventionDescriptor{
      .name = "obstacle",
      .title = {"an obstacle", "un obstáculo"},
      .subject = "mover",
      .arguments = kPoint,
      .code = 1,
      .line = {"\"{subject}\" put at ({x_m}, {y_m})", "\"{subject}\" puesto en ({x_m}, {y_m})"}}};
  return kList;
}

Result<Intervened> Simulation::intervene(const Intervention& what) {
  const InterventionDescriptor* descriptor = find(interventions(), what.name);
  if (descriptor == nullptr) return Application::intervene(what);
  const auto arguments = arguments_of(*descriptor, what);
  if (!arguments) return tl::unexpected<Error>(arguments.error());
  const auto movers = world_.movers();
  const auto found =
      std::find_if(movers.begin(), movers.end(), [&](const MoverState& mover) { return mover.id == what.subject; });
  if (found == movers.end()) {
    std::vector<std::string> ids;
    for (const MoverState& mover : movers) ids.emplace_back(mover.id);
    const Sentence sentence = say({"the world has no mover \"{}\"{}", "el mundo no tiene el obstáculo móvil \"{}\"{}"},
                                  what.subject, suggestion(what.subject, ids));
    return tl::unexpected<Error>(Error{ErrorCode::NotFound, sentence, {}, {.found = what.subject, .choices = ids}});
  }
  const Vector2 point{(*arguments)[0], (*arguments)[1]};
  const auto put = world_.put_mover(static_cast<std::size_t>(found - movers.begin()), point, neighbours_.discs());
  if (!put) return tl::unexpected<Error>(put.error());
  return Intervened{{{"x_m", point.x}, {"y_m", point.y}}};
}

}  // namespace ganglion::sim
