#include "ganglion/studio/live/messages.h"

#include "ganglion/base/json_depth.h"
#include "ganglion/run/interference.h"

namespace ganglion::studio {
namespace {

int robot_of(std::string_view topic) {
  constexpr std::string_view kRobot = "/robot";
  int number = 0;
  if (!topic.starts_with(kRobot)) return 0;
  for (const char c : topic.substr(kRobot.size())) {
    if (c < '0' || c > '9' || number > 100'000) break;
    number = number * 10 + (c - '0');
  }
  return number;
}

std::string text_in(const Json& content, const char* member, std::string otherwise = "") {
  const auto found = content.find(member);
  return found != content.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

}  // namespace

std::optional<SampleKind> sample_kind_of(std::string_view schema) noexcept {
  if (schema == "foxglove.Grid") return SampleKind::Grid;
  if (schema == "ganglion.Path") return SampleKind::Path;
  if (schema == "ganglion.Movers") return SampleKind::Movers;
  return std::nullopt;
}

std::optional<RunEvent> event_of(std::string_view topic, std::string_view schema, double time_s,
                                 std::string_view json) {
  const bool goal = schema == "ganglion.Goal", intervention = schema == kInterventionSchema;
  if (!goal && !intervention && schema != "foxglove.Log") return std::nullopt;
  Json content = parsed(json);
  if (!content.is_object()) return std::nullopt;
  content.erase("timestamp");
  content["time_s"] = time_s;
  if (goal) content["robot"] = robot_of(topic);
  const std::string name = goal ? "goal" : intervention ? "intervention" : "log";
  if (name == "log") {
    const std::string english = text_in(content, "message");
    content["message_es"] = text_in(content, "message_es", english);  // files of before said it in English only
  }
  return RunEvent{name, std::move(content)};
}

Json parsed(std::string_view text) {
  if (!json_nests_within(text, kDeepestJson) || !json_has_few_keys(text)) return {};
  Json json = Json::parse(text, nullptr, false);
  return json.is_discarded() ? Json() : json;
}

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace ganglion::studio
