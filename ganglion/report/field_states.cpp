#include "ganglion/report/field_states.h"

#include <algorithm>
#include <optional>

namespace ganglion::report {
namespace {

constexpr std::size_t kMostCompared = std::size_t{1} << 28;  // cells of all states together

/// The rectangle of cells that hold anything; of no columns where none does.
shown::Patch known_part(const shown::Field& field) {
  int left = field.columns, right = 0, low = field.rows, high = 0;
  for (const auto& layer : field.cells) {
    for (int row = 0; row < field.rows; ++row) {
      const auto begin = layer.begin() + static_cast<std::ptrdiff_t>(row) * field.columns, end = begin + field.columns;
      const auto known = [](std::uint8_t byte) { return byte != shown::kUnknownCell; };
      const auto first = std::find_if(begin, end, known);
      if (first == end) continue;
      left = std::min(left, static_cast<int>(first - begin));
      low = std::min(low, row), high = std::max(high, row + 1);
      auto last = end;
      while (!known(*(last - 1))) --last;
      right = std::max(right, static_cast<int>(last - begin));
    }
  }
  return {left, low, right - left, high - low, {}};
}

/// The field without its unknown edges.
shown::Field trimmed(const shown::Field& field, const shown::Patch& part) {
  shown::Field result = field;
  result.origin += {part.column * field.cell.x, part.row * field.cell.y};
  result.columns = part.columns;
  result.rows = part.rows;
  for (std::size_t layer = 0; layer < field.cells.size(); ++layer) {
    result.cells[layer].clear();
    for (int row = part.row; row < part.row + part.rows; ++row) {
      const auto from = field.cells[layer].begin() + static_cast<std::ptrdiff_t>(row) * field.columns + part.column;
      result.cells[layer].insert(result.cells[layer].end(), from, from + part.columns);
    }
  }
  return result;
}

const shown::Field* last_whole(const ExhibitTrack& track) {
  for (auto state = track.states.rbegin(); state != track.states.rend(); ++state) {
    if (const auto* field = std::get_if<shown::Field>(&state->form)) return field;
  }
  return nullptr;
}

}  // namespace

FieldStates states_of(const ExhibitTrack& track, std::size_t most_states, std::size_t max_cells) {
  FieldStates result;
  const shown::Field* last = last_whole(track);
  if (last == nullptr || last->layers.empty()) return result;
  const std::size_t size = last->cells[0].size() * last->layers.size();
  const std::size_t most = std::clamp<std::size_t>(kMostCompared / size, 2, most_states);
  const std::size_t every = (track.states.size() + most - 1) / most;
  std::optional<shown::Field> before;
  std::size_t index = 0;
  for_each_state(track, [&](double time_s, const shown::Field& now) {
    const bool taken = index % every == 0 || index + 1 == track.states.size();
    ++index;
    if (!taken || now.layers != last->layers) return;
    const shown::Patch part = known_part(now);
    if (part.columns <= 0) return;
    if (static_cast<std::size_t>(part.columns) * static_cast<std::size_t>(part.rows) > max_cells) return;
    shown::Field cut = trimmed(now, part);
    if (!before || !cut.same_make(*before)) {
      result.states.push_back({time_s, cut});
    } else if (auto patch = shown::difference(*before, cut)) {
      result.states.push_back({time_s, std::move(*patch)});
    }
    before = std::move(cut);
  });
  return result;
}

std::vector<std::uint8_t> run_lengths(const std::vector<std::uint8_t>& bytes) {
  std::vector<std::uint8_t> runs;
  for (std::size_t i = 0; i < bytes.size();) {
    std::size_t end = i + 1;
    while (end < bytes.size() && bytes[end] == bytes[i] && end - i < 256) ++end;
    runs.push_back(static_cast<std::uint8_t>(end - i - 1));
    runs.push_back(bytes[i]);
    i = end;
  }
  return runs;
}

}  // namespace ganglion::report
