#include "ganglion/studio/api/choice_routes.h"

#include "ganglion/descriptor/kinds_json.h"
#include "ganglion/kinds/kinds.h"

namespace ganglion::studio {
namespace {

Reply kinds() {
  std::vector<const Descriptor*> kinds;
  for (const Descriptor* kind : all_descriptors()) {
    if (kind->component_class <= ComponentClass::Coordinator) kinds.push_back(kind);
  }
  return {200, "application/json", kinds_json(kinds)};
}

Reply allowed(const std::vector<AllowedProgram>& programs) {
  Json list = Json::array();
  for (const AllowedProgram& program : programs) list.push_back({{"name", program.name}, {"help", program.help}});
  return json_reply({{"programs", std::move(list)}});
}

}  // namespace

void add_choice_routes(Router& router, const std::vector<AllowedProgram>& programs) {
  router.get("/api/kinds", [](const Ask&) { return kinds(); });
  router.get("/api/programs", [&programs](const Ask&) { return allowed(programs); });
}

}  // namespace ganglion::studio
