#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "ganglion/plot/json_view.h"

namespace ganglion::plot {
namespace {

/// The candidates as they are named in the signals: "escape" for the wire "escape.command".
std::vector<std::string> candidates_in(const Json& coordinator) {
  constexpr std::string_view kPort = ".command";
  std::vector<std::string> names;
  const auto list = coordinator.is_object() ? coordinator.find("candidates") : coordinator.end();
  if (list == coordinator.end() || !list->is_array()) return names;
  for (const Json& candidate : *list) {
    if (!candidate.is_string() || names.size() >= 1000) continue;
    names.push_back(candidate.get<std::string>());
    if (names.back().ends_with(kPort)) names.back().resize(names.back().size() - kPort.size());
  }
  return names;
}

/// Where one candidate's will and weight are recorded.
struct Columns {
  std::optional<std::size_t> wanted;
  std::optional<std::size_t> share;
};

Columns columns_of(const SignalTable& signals, const std::string& coordinator, const std::string& candidate) {
  Columns columns{signals.find(fmt::format("{}.wanted.{}", coordinator, candidate)),
                  signals.find(fmt::format("{}.share.{}", coordinator, candidate))};
  if (!columns.wanted) columns.wanted = signals.find(candidate + ".active");
  return columns;
}

}  // namespace

std::optional<Coordination> coordination_from(const Json& coordinator, const SignalTable& signals) {
  Coordination result;
  result.coordinator = text_in(coordinator, "id");
  result.candidates = candidates_in(coordinator);
  const auto active = signals.find(result.coordinator + ".active");
  if (!active || result.candidates.empty()) return std::nullopt;
  std::vector<Columns> columns;
  for (const std::string& name : result.candidates) columns.push_back(columns_of(signals, result.coordinator, name));
  result.times_s = signals.times_s;
  for (std::size_t row = 0; row < signals.rows(); ++row) {
    const double winner = signals.at(row, *active);
    const bool valid = winner >= 0 && winner < static_cast<double>(result.candidates.size());
    result.active.push_back(static_cast<std::int16_t>(valid ? winner : -1));
    for (const Columns& column : columns) {
      result.wanted.push_back(column.wanted && signals.at(row, *column.wanted) > 0);
      result.shares.push_back(column.share ? static_cast<float>(signals.at(row, *column.share)) : 0);
    }
  }
  const auto split = [](float share) { return share > 0 && share < 1; };
  if (std::ranges::none_of(result.shares, split)) result.shares.clear();
  return result;
}

}  // namespace ganglion::plot
