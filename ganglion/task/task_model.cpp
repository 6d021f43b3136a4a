#include "ganglion/task/task_model.h"

#include "ganglion/config/named_tables.h"
#include "ganglion/module/find_kind.h"

namespace ganglion {

void read_task(config::Table& table, std::span<const TaskKind* const> kinds, std::vector<std::string>& ids,
               Description& description, std::vector<TaskModel>& tasks) {
  TaskModel model;
  model.place = table.place("kind");
  model.id = table.text("id");
  table.set_context(model.id);
  config::check_name(table, "id", model.id, false, ids);
  model.kind = find_kind(table, kinds);
  if (model.kind == nullptr) return;
  model.parameters = table.parameters(model.kind->descriptor.parameters);
  const auto task = made(*model.kind, model.parameters, table);
  if (task == nullptr) return;
  model.form = task->form();
  model.form.task = model.id;
  std::size_t n = 0;
  for (const PortDescriptor& port : model.kind->descriptor.ports) {
    const Task::Limits limits = task->limits(n++);
    description.sensations.push_back({.name = model.id + "." + std::string(port.name),
                                      .unit = std::string(port.unit),
                                      .type = port.type,
                                      .elements = element_names(port),
                                      .min = limits.min,
                                      .max = limits.max});
  }
  tasks.push_back(std::move(model));
}

std::vector<TaskModel> read_tasks(config::Table& root, std::span<const TaskKind* const> kinds,
                                  std::vector<std::string>& ids, Description& description) {
  std::vector<TaskModel> tasks;
  config::each_table(root, "task", [&](config::Table& table) { read_task(table, kinds, ids, description, tasks); });
  return tasks;
}

std::vector<std::string> ids_of(std::span<const TaskModel> tasks) {
  std::vector<std::string> ids;
  for (const TaskModel& task : tasks) ids.push_back(task.id);
  return ids;
}

std::vector<LedgerForm> ledgers_of(std::span<const TaskModel> tasks) {
  std::vector<LedgerForm> forms;
  for (const TaskModel& task : tasks) {
    if (!task.form.columns.empty()) forms.push_back(task.form);
  }
  return forms;
}

}  // namespace ganglion
