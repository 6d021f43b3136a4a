#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ganglion/record/exhibit/shown.h"

namespace ganglion {

/// Who shows something: component or task of a robot, or the application as a whole.
struct ExhibitOwner {
  int robot = -1;    ///< -1: of the whole application.
  std::string name;  ///< Of the component or task; "" = the application itself.
  friend bool operator==(const ExhibitOwner&, const ExhibitOwner&) = default;
};

/// Name of the form in topics: "field" of a patch as well.
std::string_view form_name(const shown::Exhibit& exhibit) noexcept;
/// "/robot0/exhibit/router/field/map", "/exhibit/frame/pole".
std::string exhibit_topic(const ExhibitOwner& owner, std::string_view form, std::string_view name);

/// All states of one thing that was shown, in the order of time.
struct ExhibitTrack {
  ExhibitOwner owner;
  std::string form, name;
  std::vector<double> times_s;
  std::vector<shown::Exhibit> states;  ///< Of a field whole ones and patches, the first whole.

  /// The newest title in words; the name where there is none.
  Sentence title() const;
  /// What held at a time, of a form of that type; null before the first. Not of fields.
  template <class T>
  const T* at(double time_s) const noexcept {
    const auto index = index_at(time_s);
    return index ? std::get_if<T>(&states[*index].form) : nullptr;
  }
  std::optional<std::size_t> index_at(double time_s) const noexcept;
  /// Takes the state; false where it cannot be: of another form, older than the last, a patch that does not fit.
  bool add(double time_s, shown::Exhibit state);

 private:
  std::size_t whole_ = 0;  ///< Of the last whole field.
};

/// An empty track by its topic; none where it is no topic of an exhibit.
std::optional<ExhibitTrack> track_of(std::string_view topic);

/// The field as it was; none before its first state, or where the track shows something else.
std::optional<shown::Field> field_at(const ExhibitTrack& track, double time_s);

/// Goes through the states of a field in order: `use(time_s, field)`.
template <class Use>
void for_each_state(const ExhibitTrack& track, Use use) {
  shown::Field now;
  for (std::size_t i = 0; i < track.states.size(); ++i) {
    const auto& form = track.states[i].form;
    if (const auto* whole = std::get_if<shown::Field>(&form)) {
      now = *whole;
    } else if (const auto* patch = std::get_if<shown::Patch>(&form)) {
      apply(*patch, now);
    } else {
      return;
    }
    use(track.times_s[i], std::as_const(now));
  }
}

}  // namespace ganglion
