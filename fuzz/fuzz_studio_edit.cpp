// What the studio's page can send about a drawing. An input is the text of a controller, a zero, and a list of
// operations in JSON: the text must open whatever it is, and what the operations make of it is refused or opens again,
// as formatted as it can be.
#include <nlohmann/json.hpp>
#include <set>

#include "fuzz/target.h"
#include "ganglion/base/json_depth.h"
#include "ganglion/config/format.h"
#include "ganglion/config/value.h"
#include "ganglion/studio/document/connect.h"
#include "ganglion/studio/document/edit.h"

namespace ganglion::fuzz {
namespace {

using studio::Json;

const studio::DocumentPlace& place() {
  static const studio::DocumentPlace kPlace = [] {
    put("robot.toml",
        "format = 1\nname = \"r\"\ntick_s = 0.1\n[body]\nlength_m = 0.24\nwidth_m = 0.2\n[drive]\nkind = \"Tracked\"\n"
        "[[sensor]]\nid = \"sonar_left\"\nkind = \"Sonar\"\n[[sensor]]\nid = \"sonar_right\"\nkind = \"Sonar\"\n"
        "[[sensor]]\nid = \"compass\"\nkind = \"Compass\"\n");
    return studio::DocumentPlace{folder() / "controller.toml", folder()};
  }();
  return kPlace;
}

/// What the page is told of a text: JSON, whatever the text holds.
Json opened(std::string_view text) {
  DiskFiles files;
  const studio::Drawing drawing = studio::open_drawing(text, place(), files);
  Json model = Json::parse(studio::drawing_json(drawing, text, Language::Spanish), nullptr, false);
  must(model.is_object(), "a model is JSON", std::string(text));
#ifdef GANGLION_PLANTED_BUG
  std::set<Json> ids;  // "no two components have the same id"
  for (const Json& component : model["components"]) must(ids.insert(component["id"]).second, "the planted bug");
#endif
  return model;
}

/// Questions about wires among what is there.
void ask(std::string_view text, const Json& model) {
  DiskFiles files;
  const studio::Drawing drawing = studio::open_drawing(text, place(), files);
  const Json& components = model["components"];
  if (components.empty() || components.size() > 12) return;
  const std::string first = components.front()["id"], last = components.back()["id"];
  static_cast<void>(studio::targets_of(drawing, first));
  static_cast<void>(studio::sources_for(drawing, last, "left"));
  static_cast<void>(studio::may_connect(drawing, first, last, "commands"));
}

}  // namespace

void run_input(std::string_view input) {
  const std::size_t end = std::min(input.find('\0'), input.size());
  const std::string_view text = input.substr(0, end), asked = input.substr(std::min(end + 1, input.size()));
  ask(text, opened(text));
  if (!json_nests_within(asked, kDeepestJson)) return;
  const Json operations = Json::parse(asked, nullptr, false);
  if (operations.is_discarded()) return;
  const auto edited = studio::edit(text, operations);
  if (!edited) {
    must(!edited.error().what.empty(), "a refusal has a reason");
    return;
  }
  opened(edited->text);
  const auto formatted = config::format(edited->text, "");
  must(!formatted || *formatted == edited->text, "what comes back is formatted", edited->text);
  must(!config::parse(text, "") || formatted, "what could be read still can", edited->text);
  const auto again = studio::edit(edited->text, Json::array());
  must(again && again->text == edited->text, "no operation, no change", edited->text);
  static_cast<void>(studio::copy(edited->text, edited->ids));
}

}  // namespace ganglion::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ganglion::fuzz::run_input({reinterpret_cast<const char*>(data), size});
  return 0;
}
