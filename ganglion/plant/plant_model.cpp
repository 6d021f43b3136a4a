#include "ganglion/module/find_kind.h"
#include "ganglion/plant/plant_application.h"
#include "ganglion/task/tasked_application.h"

namespace ganglion {
namespace {

constexpr int kMostPlants = 100;  // a dead time of a minute takes each of them 1 MB

}  // namespace

/// Its ports are its channels; `trial` stands behind them.
void PlantModel::describe(const Plant& plant) {
  std::size_t output = 0, value = 0;
  for (const PortDescriptor& port : kind_->descriptor.ports) {
    if (port.role == PortRole::Command) {
      CommandChannel channel{std::string(port.name), {}};
      for (int n = 0; n < port.width(); ++n) channel.elements.push_back(plant.element(value++));
      own_.commands.push_back(std::move(channel));
      continue;
    }
    const Plant::Limits limits = plant.limits(output++);
    own_.sensations.push_back({.name = std::string(port.name),
                               .unit = std::string(port.unit),
                               .type = port.type,
                               .elements = element_names(port),
                               .min = limits.min,
                               .max = limits.max});
  }
  own_.sensations.push_back({.name = "trial", .type = ValueType::Discrete, .min = 0, .max = 4294967295});
  for (const PlantTruth& one : plant.truths()) {
    truth_.push_back({std::string(one.name), std::string(one.unit), say({"{}", "{}"}, one.title), one.digested});
  }
}

std::shared_ptr<const ApplicationModel> PlantModel::read(const ApplicationSource& source,
                                                         std::span<const PlantKind* const> kinds,
                                                         std::span<const TaskKind* const> tasks, Problems& problems) {
  const std::size_t before = problems.size();
  auto model = std::make_shared<PlantModel>();
  if (source.setting != nullptr && source.world >= 0) {
    source.setting->problem(
        "world", ErrorCode::BadParameter,
        {"a plant stands in no world: leave it out", "una planta no está en ningún mundo: quítelo"});
  }
  model->plants_ = source.robots;
  if (source.setting != nullptr && source.robots > kMostPlants) {
    source.setting->problem("robots", ErrorCode::TooLarge,
                            {"{} plants; the limit is {}", "{} plantas; el límite es {}"}, source.robots, kMostPlants);
  }
  {
    config::Table root(source.file, "", problems, source.outline);
    root.opens_by(source.files);
    config::check_format(root);
    model->own_.name = root.text("name");
    model->own_.tick_s = root.number("tick_s", 0.1, config::Range{1e-3, 60});
    model->kind_ = find_kind(root, kinds);
    if (model->kind_ == nullptr) return nullptr;
    model->parameters_ = root.parameters(model->kind_->descriptor.parameters);
    if (const auto plant = made(*model->kind_, model->parameters_, root)) model->describe(*plant);
    model->tasked_ = model->own_;
    std::vector<std::string> ids;
    for (const SensationChannel& channel : model->own_.sensations) ids.push_back(channel.name);
    model->tasks_ = read_tasks(root, tasks, ids, model->tasked_);
    model->task_ids_ = ids_of(model->tasks_);
    model->ledgers_ = ledgers_of(model->tasks_);
  }
  return problems.size() == before ? model : nullptr;
}

Result<std::unique_ptr<Application>> PlantModel::make() const {
  std::vector<std::unique_ptr<Plant>> plants;
  for (int n = 0; n < plants_; ++n) {
    auto plant = kind_->make(parameters_);
    if (!plant) return tl::unexpected<Error>(plant.error());
    plants.push_back(std::move(*plant));
  }
  return TaskedApplication::make(std::make_unique<PlantApplication>(own_, truth_, std::move(plants)), tasked_, tasks_);
}

}  // namespace ganglion
