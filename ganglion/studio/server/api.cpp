#include "ganglion/studio/server/api.h"

#include <cmath>

#include "ganglion/base/file.h"
#include "ganglion/base/json_depth.h"
#include "ganglion/descriptor/kinds_json.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/studio/document/wording.h"

namespace ganglion::studio {

Api::Api(Folder folder, std::vector<AllowedProgram> programs, Hooks hooks)
    : folder_(folder), listing_(folder), programs_(std::move(programs)), hooks_(std::move(hooks)) {}

const std::map<std::string, std::pair<std::string_view, Api::Route>>& Api::routes() {
  static const std::map<std::string, std::pair<std::string_view, Route>> kRoutes = {
      {"/api/kinds", {"GET", &Api::kinds}},
      {"/api/files", {"GET", &Api::files}},
      {"/api/programs", {"GET", &Api::programs}},
      {"/api/file/open", {"POST", &Api::open_file}},
      {"/api/file/save", {"POST", &Api::save_file}},
      {"/api/file/autosave", {"POST", &Api::autosave_file}},
      {"/api/file/discard", {"POST", &Api::discard_draft}},
      {"/api/document/open", {"POST", &Api::open_document}},
      {"/api/document/edit", {"POST", &Api::edit_document}},
      {"/api/document/may_connect", {"POST", &Api::ask_connection}},
      {"/api/document/targets", {"POST", &Api::list_targets}},
      {"/api/document/copy", {"POST", &Api::copy_components}},
      {"/api/link/test", {"POST", &Api::test_link}},
      {"/api/link", {"GET", &Api::link_test}},
      {"/api/run", {"GET", &Api::run_state}},
      {"/api/run/start", {"POST", &Api::start_run}},
      {"/api/run/pause", {"POST", &Api::pause_run}},
      {"/api/run/resume", {"POST", &Api::resume_run}},
      {"/api/run/step", {"POST", &Api::step_run}},
      {"/api/run/stop", {"POST", &Api::stop_run}},
      {"/api/run/reset", {"POST", &Api::reset_run}},
      {"/api/run/pace", {"POST", &Api::pace_run}},
      {"/api/run/goal", {"POST", &Api::set_goal}},
      {"/api/run/obstacle", {"POST", &Api::put_obstacle}},
      {"/api/recording/open", {"POST", &Api::open_recording}},
      {"/api/recording/samples", {"POST", &Api::recording_samples}},
      {"/api/recording/report", {"GET", &Api::recording_report}},
      {"/api/recording/controller", {"POST", &Api::recording_controller}}};
  return kRoutes;
}

Reply Api::handle(const Call& call) {
  const auto route = routes().find(call.path);
  if (route == routes().end()) return failure("UnknownPath", "there is nothing at this path", 404);
  const auto& [method, answer] = route->second;
  const bool reads = method == "GET" && call.method == "HEAD";
  if (call.method != method && !reads) return failure("BadRequest", fmt::format("this path takes {}", method), 405);
  Ask ask{call, Json::object()};
  if (method == "POST") {
    if (!json_has_few_keys(call.body)) return failure("TooLarge", "an object of the body has too many keys", 413);
    ask.body = call.body.empty() ? Json::object() : parsed(call.body);
    if (!ask.body.is_object()) return ask.refuse("BadRequest", "the body must be a JSON object", 400);
  }
  if (ask.text("language") == "es") ask.language = Language::Spanish;
  try {
    return (this->*answer)(ask);
  } catch (const nlohmann::json::exception&) {  // how the library says that a member is of another type
    return ask.refuse("BadRequest", "a member of the body is of another type than it should be", 400);
  } catch (const std::bad_alloc&) {
    return ask.refuse("TooLarge", "there is not enough memory for that", 413);
  }
}

std::string Api::Ask::text(const char* key) const {
  const auto found = body.find(key);
  return found != body.end() && found->is_string() ? found->get<std::string>() : std::string();
}

Reply Api::Ask::refuse(std::string_view code, std::string_view message, unsigned status, const Json& arguments) const {
  return failure(code, worded(message, language), status, arguments);
}

double Api::Ask::number(const char* key, double preset) const {
  const auto found = body.find(key);
  const bool good = found != body.end() && found->is_number() && std::isfinite(found->get<double>());
  return good ? found->get<double>() : preset;
}

Reply Api::kinds(const Ask&) {
  std::vector<const Descriptor*> kinds;
  for (const Descriptor* kind : all_descriptors()) {
    if (kind->component_class <= ComponentClass::Coordinator) kinds.push_back(kind);
  }
  return {200, "application/json", kinds_json(kinds)};
}

Reply Api::files(const Ask&) { return json_reply(listing_.json()); }

Reply Api::programs(const Ask&) {
  Json list = Json::array();
  for (const AllowedProgram& program : programs_) list.push_back({{"name", program.name}, {"help", program.help}});
  return json_reply({{"programs", std::move(list)}});
}

Reply Api::open_file(const Ask& ask) {
  const std::string name = ask.text("path");
  auto file = folder_.read(name);
  if (!file) return failure(file.error(), ask.language);
  note_opened(name, file->hash);
  Json json = {{"path", name}, {"text", file->text}, {"hash", file->hash}, {"draft", nullptr}};
  if (file->draft) json["draft"] = {{"text", file->draft->text}, {"based_on", file->draft->based_on}};
  return json_reply(json);
}

Reply Api::save_file(const Ask& ask) {
  const std::string name = ask.text("path");
  if (!ask.body.contains("text") || !ask.body["text"].is_string() || !ask.body.contains("based_on")) {
    return ask.refuse("BadRequest", "path, text and based_on are needed", 400);
  }
  const auto saved = folder_.save(name, ask.text("text"), ask.text("based_on"));
  if (!saved) return failure(saved.error(), ask.language);
  if (!*saved) {
    const Conflict& now = saved->error();
    return ask.refuse("Conflict", "the file has changed since it was opened", 409,
                      {{"hash", now.hash}, {"text", now.text}});
  }
  note_opened(name, **saved);
  hooks_.on_hub([name, hash = **saved](Hub& hub) { hub.event("file", {{"path", name}, {"hash", hash}}); });
  return json_reply({{"hash", **saved}});
}

Reply Api::autosave_file(const Ask& ask) {
  if (!ask.body.contains("text") || !ask.body["text"].is_string()) {
    return ask.refuse("BadRequest", "path, text and based_on are needed", 400);
  }
  const auto kept = folder_.autosave(ask.text("path"), ask.text("text"), ask.text("based_on"));
  return kept ? json_reply(Json::object()) : failure(kept.error(), ask.language);
}

Reply Api::discard_draft(const Ask& ask) {
  const auto gone = folder_.discard(ask.text("path"));
  return gone ? json_reply(Json::object()) : failure(gone.error(), ask.language);
}

void Api::note_opened(const std::string& name, const std::string& hash) {
  if (opened_.size() < 1000 || opened_.contains(name)) opened_[name] = hash;
}

void Api::look_for_changes() {
  for (auto& [name, hash] : opened_) {
    const auto path = folder_.resolve(name);
    std::error_code error;
    const auto time = path ? std::filesystem::last_write_time(*path, error) : std::filesystem::file_time_type{};
    auto& known = changed_[name];
    if (!error && known == time) continue;
    known = time;
    const auto file = path && !error ? folder_.read(name) : Result<OpenedFile>(tl::unexpected<Error>(Error{}));
    const std::string now = file ? file->hash : "";
    if (now == hash) continue;
    hash = now;
    hooks_.on_hub([name = name, now](Hub& hub) { hub.event("file", {{"path", name}, {"hash", now}}); });
  }
}

}  // namespace ganglion::studio
