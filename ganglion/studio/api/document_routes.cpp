#include "ganglion/studio/api/document_routes.h"

#include "ganglion/studio/document/connect.h"
#include "ganglion/studio/document/drawing.h"
#include "ganglion/studio/document/edit.h"
#include "ganglion/studio/folder/folder_files.h"

namespace ganglion::studio {
namespace {

Json connection_json(const Connection& connection, Language language) {
  Json reasons = Json::array();
  for (const Sentence& reason : connection.reasons) reasons.push_back(reason.in(language));
  return {{"ok", connection.reasons.empty()}, {"reasons", std::move(reasons)}};
}

/// Where the text lives; the file itself need not be there yet.
Result<DocumentPlace> place_of(const Ask& ask, const Folder& folder) {
  auto path = folder.resolve(ask.text("path"));
  if (!path) return tl::unexpected<Error>(path.error());
  return DocumentPlace{*path, folder.root()};
}

Reply open_document(const Ask& ask, const Folder& folder) {
  const auto place = place_of(ask, folder);
  if (!place) return failure(place.error(), ask.language);
  const std::string text = ask.text("text");
  FolderFiles files(folder);
  const Drawing drawing = open_drawing(text, *place, files);
  return {200, "application/json", "{\"model\":" + drawing_json(drawing, text, ask.language) + "}"};
}

Reply edit_document(const Ask& ask, const Folder& folder) {
  const auto place = place_of(ask, folder);
  if (!place) return failure(place.error(), ask.language);
  const auto edited = edit(ask.text("text"), ask.body.value("operations", Json()));
  if (!edited) return failure(edited.error(), ask.language, {{"operation", edited.error().place.line}});
  FolderFiles files(folder);
  const std::string model = drawing_json(open_drawing(edited->text, *place, files), edited->text, ask.language);
  return {200, "application/json",
          fmt::format("{{\"text\":{},\"ids\":{},\"model\":{}}}", dumped(edited->text), dumped(edited->ids), model)};
}

Reply ask_connection(const Ask& ask, const Folder& folder) {
  const auto place = place_of(ask, folder);
  if (!place) return failure(place.error(), ask.language);
  FolderFiles files(folder);
  const Drawing drawing = open_drawing(ask.text("text"), *place, files);
  const Connection connection = may_connect(drawing, ask.text("from"), ask.text("to"), ask.text("port"));
  return json_reply(connection_json(connection, ask.language));
}

Reply list_targets(const Ask& ask, const Folder& folder) {
  const auto place = place_of(ask, folder);
  if (!place) return failure(place.error(), ask.language);
  FolderFiles files(folder);
  const Drawing drawing = open_drawing(ask.text("text"), *place, files);
  const bool to = ask.has("to");
  Json list = Json::array();
  const auto all = to ? sources_for(drawing, ask.text("to"), ask.text("port")) : targets_of(drawing, ask.text("from"));
  for (const Connection& one : all) {
    Json entry = to ? Json{{"from", one.from}} : Json{{"id", one.component}, {"port", one.port}};
    entry.update(connection_json(one, ask.language));
    list.push_back(std::move(entry));
  }
  return json_reply({{to ? "sources" : "targets", std::move(list)}});
}

Reply copy_components(const Ask& ask) {
  std::vector<std::string> ids;
  for (const Json& id : ask.body.value("ids", Json::array()))
    ids.push_back(id.is_string() ? id.get<std::string>() : "");
  const auto toml = copy(ask.text("text"), ids);
  return toml ? json_reply({{"toml", *toml}}) : failure(toml.error(), ask.language);
}

}  // namespace

void add_document_routes(Router& router, const Folder& folder) {
  router.post("/api/document/open", [&folder](const Ask& ask) { return open_document(ask, folder); });
  router.post("/api/document/edit", [&folder](const Ask& ask) { return edit_document(ask, folder); });
  router.post("/api/document/may_connect", [&folder](const Ask& ask) { return ask_connection(ask, folder); });
  router.post("/api/document/targets", [&folder](const Ask& ask) { return list_targets(ask, folder); });
  router.post("/api/document/copy", copy_components);
}

}  // namespace ganglion::studio
