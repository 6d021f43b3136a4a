#include "ganglion/coordination/weighted_sum/weighted_sum.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ganglion {
namespace {

enum Input : std::size_t { kCommands, kWeights };

constexpr std::array kPorts = {
    PortDescriptor{.name = "commands",
                   .title = {"commands", "mandos"},
                   .help = {"Commands that are blended", "Mandos que se mezclan"},
                   .role = PortRole::Candidate,
                   .unit = "*",
                   .size = 0,
                   .many = true},
    PortDescriptor{.name = "weights",
                   .title = {"weights", "pesos"},
                   .help = {"How much each candidate counts, in their order; unwired all count alike",
                            "Cuánto cuenta cada candidato, en su orden; sin cable todos cuentan igual"},
                   .unit = "*",
                   .required = false,
                   .many = true,
                   .each_candidate = true},
    PortDescriptor{.name = "command",
                   .title = {"command", "mando"},
                   .help = {"The blend", "La mezcla"},
                   .role = PortRole::Command,
                   .unit = "*",
                   .size = 0},
};

constexpr std::array kParameters = {
    parameter<WeightedSumConfig, &WeightedSumConfig::least_weight>(
        {.name = "least_weight",
         .title = {"least weight", "peso mínimo"},
         .help = {"A candidate that weighs this or less has no part",
                  "Un candidato que pesa esto o menos no participa"},
         .min = 0,
         .max = 1e6,
         .ours = true,
         .live = true}),
};

}  // namespace

double WeightedSum::weight(const Feedback& feedback, std::span<const Command* const> candidates,
                           std::size_t i) const noexcept {
  if (candidates[i]->kind != CommandKind::Act) return 0;
  const PortView& weights = feedback[kWeights];
  const double weight = weights.wired() ? weights.values[i] : 1;
  return weight > config_.least_weight && std::isfinite(weight) ? weight : 0;
}

Command WeightedSum::coordinate(const Feedback& feedback, std::span<const Command* const> candidates,
                                std::span<double> shares) noexcept {
  Command blend;
  double sum = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Command& command = *candidates[i];
    const double weight = this->weight(feedback, candidates, i);
    if (weight == 0 || (sum > 0 && command.size != blend.size)) continue;
    blend.size = command.size;
    blend.ttl_s = std::min(blend.ttl_s, command.ttl_s);
    for (std::size_t n = 0; n < command.span().size(); ++n) blend.values[n] += weight * command.values[n];
    shares[i] = weight;
    sum += weight;
  }
  if (sum == 0) return nobody_acts(candidates);
  blend.kind = CommandKind::Act;
  for (double& value : blend.values) value /= sum;
  for (double& share : shares) share /= sum;
  return blend;
}

extern constinit const CoordinatorKind weighted_sum_kind{
    .descriptor = {.component_class = ComponentClass::Coordinator,
                   .name = "WeightedSum",
                   .summary = {"Blends the candidates' commands by their weights",
                               "Mezcla los mandos de los candidatos según sus pesos"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "Command fusion; the mean by activation is ours"},
    .make = make_bound<Coordinator, WeightedSum, WeightedSumConfig>};

}  // namespace ganglion
