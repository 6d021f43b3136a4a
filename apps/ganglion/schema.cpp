#include <functional>
#include <map>

#include "commands.h"
#include "ganglion/base/file.h"
#include "ganglion/graph/schema.h"
#include "ganglion/kinds/applications.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/run/experiment_schema.h"
#include "say.h"

namespace ganglion {
namespace {

const std::map<std::string, std::function<std::string()>>& schemas() {
  static const std::map<std::string, std::function<std::string()>> kSchemas = {
      {"controller", [] { return controller_schema(controller_kinds()); }},
      {"experiment", experiment_schema},
      {"robot", [] { return robot_schema(); }},
      {"plant", plant_schema},
      {"world", world_schema}};
  return kSchemas;
}

int give(const std::string& schema, const std::string& file) {
  if (file.empty()) {
    fmt::print("{}", schema);
    return kDone;
  }
  const auto written = write_file(file, schema);
  if (written) return kDone;
  complain(written.error());
  return kOutputFailed;
}

}  // namespace

void add_schema(CLI::App& program, int& code) {
  struct SchemaArguments {
    std::string type, file;
  };
  auto arguments = std::make_shared<SchemaArguments>();
  CLI::App* command =
      program.add_subcommand("schema", "JSON Schema of a type of file, for editors that complete and check");
  std::vector<std::string> types;
  for (const auto& [type, schema] : schemas()) types.push_back(type);
  command->add_option("type", arguments->type, "controller, experiment, robot or world")
      ->required()
      ->check(CLI::IsMember(types));
  command->add_option("--out", arguments->file, "File to write; else it goes to standard output");
  command->footer("Example:\n  ganglion schema controller --out controller.schema.json");
  command->callback([arguments, &code] { code = give(schemas().at(arguments->type)(), arguments->file); });
}

}  // namespace ganglion
