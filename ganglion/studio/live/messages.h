#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "ganglion/record/exhibit/track.h"
#include "ganglion/studio/live/sample.h"

namespace ganglion::studio {

using Json = nlohmann::ordered_json;

/// What becomes of a run's message by its topic and schema: a sample of which the newest counts, or none: an event.
std::optional<SampleKind> sample_kind_of(std::string_view topic, std::string_view schema);

/// A message that is told once, as the page takes it.
struct RunEvent {
  std::string name;  ///< "log", "intervention"
  Json content;
};
/// None for what is no event.
std::optional<RunEvent> event_of(std::string_view schema, double time_s, std::string_view json);

/// How the page knows who shows what: {"robot", "owner", "form", "name"}.
Json whose_json(const ExhibitTrack& track);

/// The text's JSON, or null.
Json parsed(std::string_view text);
/// As a text; what is not UTF-8 is replaced.
std::string dumped(const Json& json);

}  // namespace ganglion::studio
