#include "ganglion/run/check_file.h"

#include <array>

#include "ganglion/kinds/applications.h"
#include "ganglion/run/near_file.h"
#include "ganglion/run/run.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

/// All files are read, and if they are sound a run is begun on trial: what it would be refused for is told now.
void check_experiment(FileReader& files, const fs::path& file, Problems& problems) {
  const auto prepared = prepare(files, file, {}, problems);
  if (!prepared) return;
  if (const auto started = try_start(*prepared); !started) {
    Error error = started.error();
    if (error.place.file.empty()) error.place = {file.string(), 1, 1};
    problems.add(std::move(error));
  }
}

}  // namespace

std::string kind_of_file(const config::Value& root) {
  for (const char* key : {"application", "run", "success"}) {
    if (root.find(key) != nullptr) return "experiment";
  }
  for (const char* key : {"acting", "sensing", "goal", "coordinator"}) {
    if (root.find(key) != nullptr) return "controller";
  }
  for (const char* key : {"body", "drive", "sensor", "energy", "command"}) {
    if (root.find(key) != nullptr) return "robot";
  }
  if (is_world(root)) return "world";
  if (root.find("controller") != nullptr) return "experiment";
  if (root.find("sensation") != nullptr) return "controller";
  return root.find("kind") != nullptr ? "plant" : "";
}

std::string check_file(const fs::path& given, Problems& problems) {
  std::error_code ignored;
  const fs::path file = fs::is_directory(given, ignored) ? given / "experiment.toml" : given;
  DiskFiles files;
  const auto opened = files.open("", file.string(), -1, config::kMaxBytes);
  if (opened && (file.extension() == ".yaml" || file.extension() == ".yml")) {
    check_world(files, *opened, problems);
    return "map";
  }
  const auto root = opened ? config::parse(files.at(*opened)) : tl::unexpected<Error>(opened.error());
  if (!root) {
    problems.add(opened ? root.error() : with_nearest(root.error(), file));
    return "";
  }
  const std::string kind = kind_of_file(*root);
  if (kind == "experiment") {
    check_experiment(files, file, problems);
  } else if (kind == "controller") {
    load_controller(files, *opened, {}, nullptr, problems);
  } else if (kind == "robot" || kind == "plant") {
    read_description(files, *opened, {}, problems);
  } else if (kind == "world") {
    check_world(files, *opened, problems);
  } else {
    problems.add(
        {file.string(), 1, 1}, ErrorCode::Unsupported,
        {"is neither an experiment ([application], [run]), a controller ([[acting]], ...), a robot ([body], "
         "[drive], ...), a plant (kind = ...) nor a world ([[wall]], [[box]], ...)",
         "no es ni un experimento ([application], [run]), ni un controlador ([[acting]], ...), ni un robot ([body], "
         "[drive], ...), ni una planta (kind = ...) ni un mundo ([[wall]], [[box]], ...)"});
  }
  return kind;
}

}  // namespace ganglion
