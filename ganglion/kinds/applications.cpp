#include "ganglion/kinds/applications.h"

#include <algorithm>

#include "ganglion/config/outline_schema.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/plant/plant_application.h"
#include "ganglion/sim/application/simulated_robots.h"
#include "ganglion/sim/robot/robot_schema.h"
#include "ganglion/sim/world/plan/world_schema.h"

namespace ganglion {

std::shared_ptr<const ApplicationModel> read_application(const ApplicationSource& source, Problems& problems) {
  if (source.file.find("kind") != nullptr) return PlantModel::read(source, plant_kinds(), task_kinds(), problems);
  return sim::RobotsModel::read(source, sim_kinds(), problems);
}

std::optional<Description> read_description(FileReader& files, int file, std::span<const config::Override> overrides,
                                            Problems& problems) {
  auto root = config::parse(files.at(file));
  if (!root) {
    problems.add(root.error());
    return std::nullopt;
  }
  const std::size_t before = problems.size();
  for (const config::Override& override : overrides) {
    if (const auto applied = config::apply(*root, override); !applied) problems.add(applied.error());
  }
  const auto model = read_application({.file = *root, .files = &files}, problems);
  if (model == nullptr || problems.size() != before) return std::nullopt;
  return model->description();
}

void ask_application(config::Table& setting) { sim::RobotsModel::ask(setting); }

bool is_world(const config::Value& root) {
  static const std::list<config::Outline> outlines = sim::world_outlines();
  const auto& keys = outlines.front().keys();  // every sample asks for all that may stand there
  return std::any_of(keys.begin(), keys.end(), [&](const config::Outline::Key& key) {
    return key.name != "format" && key.name != "name" && root.find(key.name) != nullptr;
  });
}

void check_world(FileReader& files, int file, Problems& problems) {
  const auto before = problems.size();
  const auto ground = sim::Ground::load(files, file, problems);
  if (!ground && problems.size() == before) problems.add(ground.error());
}

std::string robot_schema() { return sim::robot_schema(sim_kinds()); }
std::string world_schema() { return sim::world_schema(); }

std::list<config::Outline> plant_outlines() {
  std::list<config::Outline> samples;
  Problems problems;  // of kinds whose defaults do not agree: what they ask is known by then
  for (const PlantKind* plant : plant_kinds()) {
    std::string text = fmt::format("format = 1\nname = \"plant\"\nkind = \"{}\"\n", plant->descriptor.name);
    for (const TaskKind* task : task_kinds()) {
      text += fmt::format("[[task]]\nid = \"{0}\"\nkind = \"{0}\"\n", task->descriptor.name);
    }
    const auto root = config::parse(text, "sample");
    if (root) read_application({.file = *root, .outline = &samples.emplace_back()}, problems);
  }
  return samples;
}

std::string plant_schema() { return config::schema_text("Ganglion plant", plant_outlines()); }

}  // namespace ganglion
