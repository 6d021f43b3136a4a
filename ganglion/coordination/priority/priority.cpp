#include "ganglion/coordination/priority/priority.h"

#include <array>

namespace ganglion {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{
        .name = "commands",
        .title = {"commands", "mandos"},
        .help = {"Commands that compete, the most important first", "Mandos que compiten, el más importante primero"},
        .role = PortRole::Candidate,
        .unit = "*",
        .size = 0,
        .many = true},
    PortDescriptor{.name = "command",
                   .title = {"command", "mando"},
                   .help = {"The winner's command", "El mando del ganador"},
                   .role = PortRole::Command,
                   .unit = "*",
                   .size = 0},
};

}  // namespace

Result<std::unique_ptr<Coordinator>> Priority::make(const Parameters&) { return std::make_unique<Priority>(); }

Command Priority::coordinate(const Feedback&, std::span<const Command* const> candidates,
                             std::span<double> shares) noexcept {
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i]->kind != CommandKind::Act) continue;
    shares[i] = 1;
    return *candidates[i];
  }
  return nobody_acts(candidates);
}

extern constinit const CoordinatorKind priority_kind{
    .descriptor = {.component_class = ComponentClass::Coordinator,
                   .name = "Priority",
                   .summary = {"The first candidate that commands drives", "Conduce el primer candidato que manda"},
                   .ports = kPorts,
                   .source = "Alonso, robot Nimrod, sections 2 and 3"},
    .make = Priority::make};

}  // namespace ganglion
