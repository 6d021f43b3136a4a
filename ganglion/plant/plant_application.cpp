#include "ganglion/plant/plant_application.h"

#include <algorithm>

#include "ganglion/base/hash.h"

namespace ganglion {

PlantApplication::PlantApplication(Description description, std::vector<TruthChannel> truth,
                                   std::vector<std::unique_ptr<Plant>> plants)
    : description_(std::move(description)),
      truth_(std::move(truth)),
      plants_(std::move(plants)),
      states_(plants_.size()),
      commands_(static_cast<std::size_t>(description_.command_values())),
      row_(truth_.size() * plants_.size()) {}

Result<void> PlantApplication::reset(std::uint64_t seed, std::uint32_t episode) {
  seed_ = seed;
  episode_ = episode;
  tick_ = 0;
  clock_ = {};
  for (std::size_t n = 0; n < plants_.size(); ++n) {
    plants_[n]->reset();
    states_[n] = {};
  }
  return {};
}

void PlantApplication::sense(std::span<SenseFrame> frames) noexcept {
  const auto values = static_cast<std::size_t>(description_.sensation_values());
  for (std::size_t n = 0; n < frames.size(); ++n) {
    SenseFrame& frame = frames[n];
    const State& state = states_[n];
    frame.tick = tick_;
    frame.time_s = clock_.time_s();
    frame.cost = state.has_cost ? std::optional(state.cost) : std::nullopt;
    plants_[n]->sense(std::span(frame.values).first(values - 1));
    frame.values[values - 1] = state.trials;
    std::fill_n(frame.ages_s.begin(), description_.sensations.size(), 0.0);
  }
}

void PlantApplication::act(std::size_t plant, const ActFrame& frame, double step_s, Draws& draws) noexcept {
  double done_s = 0;
  while (done_s < step_s) {
    double until_s = step_s;  // while the same commands hold
    std::size_t value = 0;
    for (std::size_t channel = 0; channel < description_.commands.size(); ++channel) {
      const double ttl_s = frame.ttl_s[channel];
      const bool holds = ttl_s > done_s;
      if (holds) until_s = std::min(until_s, ttl_s);
      for (const CommandElement& element : description_.commands[channel].elements) {
        commands_[value] = holds ? frame.values[value] : element.safe;
        ++value;
      }
    }
    plants_[plant]->step(commands_, until_s - done_s, draws);
    states_[plant].cost += plants_[plant]->cost();
    done_s = until_s;
  }
}

void PlantApplication::step(std::span<const ActFrame> frames, double step_s) noexcept {
  for (std::size_t n = 0; n < frames.size(); ++n) {
    State& state = states_[n];
    state.cost = 0;
    state.has_cost = true;
    Draws draws({seed_, episode_, static_cast<std::uint32_t>(n), hash_name("plant")}, tick_ + 1);
    act(n, frames[n], step_s, draws);
    if (!plants_[n]->failed()) continue;
    plants_[n]->reset();
    state.has_cost = false;
    ++state.trials;
  }
  ++tick_;
  clock_.end_s(step_s);
  clock_.advance();
}

std::span<const double> PlantApplication::truth_of(int robot) const noexcept {
  const auto n = static_cast<std::size_t>(robot);
  const auto row = std::span(row_).subspan(n * truth_.size(), truth_.size());
  plants_[n]->tell(row);
  return row;
}

}  // namespace ganglion
