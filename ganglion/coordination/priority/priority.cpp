#include "ganglion/coordination/priority/priority.h"

#include <array>

namespace ganglion {
namespace {

enum Output : std::size_t { kActive, kShare, kWanted, kSuppressed };

constexpr std::array kPorts = {
    PortDescriptor{
        .name = "commands",
        .role = PortRole::Candidate,
        .unit = "*",
        .size = 0,
        .many = true,
        .help = {"Commands that compete, the most important first", "Mandos que compiten, el más importante primero"}},
    PortDescriptor{.name = "command",
                   .role = PortRole::Command,
                   .unit = "*",
                   .size = 0,
                   .help = {"The winner's command", "El mando del ganador"}},
    PortDescriptor{
        .name = "active",
        .role = PortRole::Output,
        .type = ValueType::Discrete,
        .help = {"Index of the candidate that drives, -1 = none", "Índice del candidato que conduce, -1 = ninguno"}},
    PortDescriptor{.name = "share",
                   .role = PortRole::Output,
                   .many = true,
                   .help = {"Part of each candidate in the result", "Parte de cada candidato en el resultado"}},
    PortDescriptor{.name = "wanted",
                   .role = PortRole::Output,
                   .type = ValueType::Discrete,
                   .many = true,
                   .help = {"1 while a candidate wants to drive", "1 mientras un candidato quiere conducir"}},
    PortDescriptor{.name = "suppressed",
                   .role = PortRole::Output,
                   .type = ValueType::Discrete,
                   .many = true,
                   .help = {"1 while a candidate wants to drive and does not",
                            "1 mientras un candidato quiere conducir y no lo hace"}},
};

/// What is commanded when no candidate acts.
Command nobody(std::span<const Command* const> candidates) noexcept {
  for (const Command* candidate : candidates) {
    if (candidate->kind != CommandKind::Withdraw) return Command::inactive();
  }
  return candidates.empty() ? Command::inactive() : *candidates.front();
}

}  // namespace

Result<std::unique_ptr<Coordinator>> Priority::make(const Parameters&) { return std::make_unique<Priority>(); }

Command Priority::coordinate(const Feedback&, std::span<const Command* const> candidates,
                             std::span<double> shares) noexcept {
  constexpr auto kNobody = static_cast<std::size_t>(-1);
  std::size_t winner = kNobody;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const bool wants = candidates[i]->kind == CommandKind::Act;
    if (wants && winner == kNobody) winner = i;
    shares[i] = winner == i ? 1 : 0;
    output(kShare)[i] = shares[i];
    output(kWanted)[i] = wants ? 1 : 0;
    output(kSuppressed)[i] = wants && winner != i ? 1 : 0;
  }
  put(kActive, winner == kNobody ? -1 : static_cast<double>(winner));
  return winner == kNobody ? nobody(candidates) : *candidates[winner];
}

extern constinit const CoordinatorKind priority_kind{
    .descriptor = {.component_class = ComponentClass::Coordinator,
                   .name = "Priority",
                   .summary = {"The first candidate that commands drives", "Conduce el primer candidato que manda"},
                   .ports = kPorts,
                   .source = "Alonso, robot Nimrod, sections 2 and 3"},
    .make = Priority::make};

}  // namespace ganglion
