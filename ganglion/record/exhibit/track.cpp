#include "ganglion/record/exhibit/track.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace ganglion {
namespace {

constexpr std::array<std::string_view, 7> kForms = {"frame", "field", "field", "curve", "bars", "marks", "network"};
constexpr std::string_view kFolder = "exhibit";

/// Cuts the first part off a path "a/b/c".
std::string_view cut(std::string_view& path) noexcept {
  const std::size_t end = path.find('/');
  const std::string_view part = path.substr(0, end);
  path = end == std::string_view::npos ? std::string_view() : path.substr(end + 1);
  return part;
}

std::optional<int> robot_in(std::string_view part) noexcept {
  constexpr std::string_view kRobot = "robot";
  if (!part.starts_with(kRobot)) return std::nullopt;
  part.remove_prefix(kRobot.size());
  int number = 0;
  const auto [end, problem] = std::from_chars(part.data(), part.data() + part.size(), number);
  const bool read = problem == std::errc() && end == part.data() + part.size() && number >= 0;
  return read ? std::optional(number) : std::nullopt;
}

}  // namespace

std::string_view form_name(const shown::Exhibit& exhibit) noexcept { return kForms[exhibit.form.index()]; }

std::string exhibit_topic(const ExhibitOwner& owner, std::string_view form, std::string_view name) {
  if (owner.robot < 0) return fmt::format("/{}/{}/{}", kFolder, form, name);
  return fmt::format("/robot{}/{}/{}/{}/{}", owner.robot, kFolder, owner.name, form, name);
}

std::optional<ExhibitTrack> track_of(std::string_view topic) {
  if (!topic.starts_with('/')) return std::nullopt;
  topic.remove_prefix(1);
  ExhibitTrack track;
  std::string_view part = cut(topic);
  if (const auto robot = robot_in(part)) {
    track.owner.robot = *robot;
    part = cut(topic);
  }
  if (part != kFolder) return std::nullopt;
  if (track.owner.robot >= 0) track.owner.name = cut(topic);
  track.form = cut(topic);
  track.name = topic;
  if (track.name.empty() || std::ranges::find(kForms, track.form) == kForms.end()) return std::nullopt;
  return track;
}

Sentence ExhibitTrack::title() const {
  for (auto state = states.rbegin(); state != states.rend(); ++state) {
    if (!state->title.empty()) return state->title;
  }
  return Sentence::quoted(name);
}

std::optional<std::size_t> ExhibitTrack::index_at(double time_s) const noexcept {
  const auto after = std::upper_bound(times_s.begin(), times_s.end(), time_s);
  if (after == times_s.begin()) return std::nullopt;
  return static_cast<std::size_t>(after - times_s.begin()) - 1;
}

bool ExhibitTrack::add(double time_s, shown::Exhibit state) {
  if (form_name(state) != form || !(times_s.empty() || time_s >= times_s.back())) return false;
  if (std::holds_alternative<shown::Field>(state.form)) {
    whole_ = states.size();
  } else if (const auto* patch = std::get_if<shown::Patch>(&state.form)) {
    if (states.empty() || !fits(*patch, std::get<shown::Field>(states[whole_].form))) return false;
  }
  times_s.push_back(time_s);
  states.push_back(std::move(state));
  return true;
}

std::optional<shown::Field> field_at(const ExhibitTrack& track, double time_s) {
  const auto last = track.index_at(time_s);
  if (!last || track.form != "field") return std::nullopt;
  std::size_t first = *last;
  while (!std::holds_alternative<shown::Field>(track.states[first].form)) --first;  // the first one is whole
  shown::Field field = std::get<shown::Field>(track.states[first].form);
  for (std::size_t i = first + 1; i <= *last; ++i) apply(std::get<shown::Patch>(track.states[i].form), field);
  return field;
}

}  // namespace ganglion
