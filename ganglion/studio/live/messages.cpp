#include "ganglion/studio/live/messages.h"

#include "ganglion/base/json_depth.h"
#include "ganglion/record/exhibit/exhibit_codec.h"
#include "ganglion/run/interference.h"

namespace ganglion::studio {
namespace {

std::string text_in(const Json& content, const char* member, std::string otherwise = "") {
  const auto found = content.find(member);
  return found != content.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

}  // namespace

std::optional<SampleKind> sample_kind_of(std::string_view topic, std::string_view schema) {
  if (schema == "ganglion.Movers") return SampleKind::Movers;
  if (schema != kExhibitSchema) return std::nullopt;
  const auto track = track_of(topic);
  return track && track->form == "field" ? SampleKind::Field : SampleKind::Exhibit;
}

std::optional<RunEvent> event_of(std::string_view schema, double time_s, std::string_view json) {
  const bool intervention = schema == kInterventionSchema;
  if (!intervention && schema != "foxglove.Log") return std::nullopt;
  Json content = parsed(json);
  if (!content.is_object()) return std::nullopt;
  content.erase("timestamp");
  content["time_s"] = time_s;
  if (intervention) return RunEvent{"intervention", std::move(content)};
  const std::string english = text_in(content, "message");
  content["message_es"] = text_in(content, "message_es", english);  // files of before said it in English only
  return RunEvent{"log", std::move(content)};
}

Json whose_json(const ExhibitTrack& track) {
  return {{"robot", track.owner.robot}, {"owner", track.owner.name}, {"form", track.form}, {"name", track.name}};
}

Json parsed(std::string_view text) {
  if (!json_nests_within(text, kDeepestJson) || !json_has_few_keys(text)) return {};
  Json json = Json::parse(text, nullptr, false);
  return json.is_discarded() ? Json() : json;
}

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace ganglion::studio
