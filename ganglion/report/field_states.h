#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "ganglion/record/exhibit/track.h"

namespace ganglion::report {

/// A field through a run as the player takes it: cut to what is ever known of it, whole where its make changes, else the
/// rectangle that changed.
struct FieldStates {
  struct State {
    double time_s = 0;
    std::variant<shown::Field, shown::Patch> change;
  };
  std::vector<State> states;
};

/// States are thinned evenly to at most `most_states`, fewer where the field is large; the last one always stays. Those
/// of other layers than it has at the end are left out. Empty where more than `max_cells` cells are known.
FieldStates states_of(const ExhibitTrack& track, std::size_t most_states = 400, std::size_t max_cells = 1u << 20);

/// Bytes as runs: how many more than one follow, then which byte. Maps are mostly runs.
std::vector<std::uint8_t> run_lengths(const std::vector<std::uint8_t>& bytes);

}  // namespace ganglion::report
