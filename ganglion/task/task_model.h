#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ganglion/config/table.h"
#include "ganglion/task/task.h"

namespace ganglion {

/// One [[task]] as a robot or plant file has it.
struct TaskModel {
  std::string id;
  const TaskKind* kind = nullptr;
  Parameters parameters{{}};
  LedgerForm form;  ///< Named after the task; without columns where it keeps nothing.
  Place place;
};

/// Reads every [[task]]: `id`, `kind` and the kind's parameters. Their channels, named "id.channel", go behind those of the
/// description. `ids`: names that are taken; those of tasks join them.
std::vector<TaskModel> read_tasks(config::Table& root, std::span<const TaskKind* const> kinds,
                                  std::vector<std::string>& ids, Description& description);

/// The same of one table that is a task, whatever its list is called.
void read_task(config::Table& table, std::span<const TaskKind* const> kinds, std::vector<std::string>& ids,
               Description& description, std::vector<TaskModel>& tasks);

/// Their ids.
std::vector<std::string> ids_of(std::span<const TaskModel> tasks);

/// What they keep.
std::vector<LedgerForm> ledgers_of(std::span<const TaskModel> tasks);

}  // namespace ganglion
