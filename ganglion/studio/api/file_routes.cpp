#include "ganglion/studio/api/file_routes.h"

namespace ganglion::studio {
namespace {

Reply needs_more(const Ask& ask) {
  const Sentence what = say({"path, text and based_on are needed", "hacen falta path, text y based_on"});
  return ask.refuse("BadRequest", what, 400);
}

}  // namespace

FileRoutes::FileRoutes(Router& router, const Folder& folder, Listing& listing, OnHub on_hub)
    : folder_(folder), listing_(listing), on_hub_(std::move(on_hub)) {
  router.get("/api/files", [this](const Ask&) { return json_reply(listing_.json()); });
  router.post("/api/file/open", [this](const Ask& ask) { return open(ask); });
  router.post("/api/file/save", [this](const Ask& ask) { return save(ask); });
  router.post("/api/file/autosave", [this](const Ask& ask) { return autosave(ask); });
  router.post("/api/file/discard", [this](const Ask& ask) { return discard(ask); });
}

Reply FileRoutes::open(const Ask& ask) {
  const std::string name = ask.text("path");
  auto file = folder_.read(name);
  if (!file) return failure(file.error(), ask.language);
  note_opened(name, file->hash);
  Json json = {{"path", name}, {"text", file->text}, {"hash", file->hash}, {"draft", nullptr}};
  if (file->draft) json["draft"] = {{"text", file->draft->text}, {"based_on", file->draft->based_on}};
  return json_reply(json);
}

Reply FileRoutes::save(const Ask& ask) {
  const std::string name = ask.text("path");
  if (!ask.body.contains("text") || !ask.body["text"].is_string() || !ask.body.contains("based_on")) {
    return needs_more(ask);
  }
  const auto saved = folder_.save(name, ask.text("text"), ask.text("based_on"));
  if (!saved) return failure(saved.error(), ask.language);
  if (!*saved) {
    const Conflict& now = saved->error();
    return ask.refuse("Conflict",
                      say({"the file has changed since it was opened", "el archivo cambió desde que se abrió"}), 409,
                      {{"hash", now.hash}, {"text", now.text}});
  }
  note_opened(name, **saved);
  on_hub_([name, hash = **saved](Hub& hub) { hub.event("file", {{"path", name}, {"hash", hash}}); });
  return json_reply({{"hash", **saved}});
}

Reply FileRoutes::autosave(const Ask& ask) const {
  if (!ask.body.contains("text") || !ask.body["text"].is_string()) {
    return needs_more(ask);
  }
  const auto kept = folder_.autosave(ask.text("path"), ask.text("text"), ask.text("based_on"));
  return kept ? json_reply(Json::object()) : failure(kept.error(), ask.language);
}

Reply FileRoutes::discard(const Ask& ask) const {
  const auto gone = folder_.discard(ask.text("path"));
  return gone ? json_reply(Json::object()) : failure(gone.error(), ask.language);
}

void FileRoutes::note_opened(const std::string& name, const std::string& hash) {
  if (opened_.size() < 1000 || opened_.contains(name)) opened_[name] = hash;
}

void FileRoutes::look_for_changes() {
  for (auto& [name, hash] : opened_) {
    const auto path = folder_.resolve(name);
    std::error_code error;
    const auto time = path ? std::filesystem::last_write_time(*path, error) : std::filesystem::file_time_type{};
    auto& known = changed_[name];
    if (!error && known == time) continue;
    known = time;
    const auto file = path && !error ? folder_.read(name) : Result<StoredText>(tl::unexpected<Error>(Error{}));
    const std::string now = file ? file->hash : "";
    if (now == hash) continue;
    hash = now;
    on_hub_([name = name, now](Hub& hub) { hub.event("file", {{"path", name}, {"hash", now}}); });
  }
}

}  // namespace ganglion::studio
