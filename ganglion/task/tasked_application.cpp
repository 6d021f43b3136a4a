#include "ganglion/task/tasked_application.h"

#include <algorithm>
#include <limits>

#include "ganglion/base/hash.h"
#include "ganglion/base/text.h"

namespace ganglion {

TaskedApplication::TaskedApplication(std::unique_ptr<Application> inner, Description description)
    : inner_(std::move(inner)),
      truth_(inner_->witness()),
      description_(std::move(description)),
      own_values_(static_cast<std::size_t>(inner_->description().sensation_values())),
      own_channels_(inner_->description().sensations.size()) {}

Result<std::unique_ptr<Application>> TaskedApplication::make(std::unique_ptr<Application> inner,
                                                             Description description,
                                                             std::span<const TaskModel> tasks) {
  if (tasks.empty()) return inner;
  if (inner->witness() == nullptr) {
    return fail(ErrorCode::Unsupported,
                {"\"{}\" is set a task, but nobody there knows what is true of it",
                 "a \"{}\" se le fija una tarea, pero allí nadie sabe qué es cierto de él"},
                description.name);
  }
  std::unique_ptr<TaskedApplication> made(new TaskedApplication(std::move(inner), std::move(description)));
  for (const TaskModel& task : tasks) {
    if (auto added = made->add(task); !added) {
      Error error = added.error();
      error.what = say({"{}: {}", "{}: {}"}, task.id, error.what);
      if (error.place.file.empty()) error.place = task.place;
      return tl::unexpected<Error>(std::move(error));
    }
  }
  made->ledgers_ = ledgers_of(tasks);
  std::ranges::copy(made->inner_->interventions(), std::back_inserter(made->interventions_));
  return std::unique_ptr<Application>(std::move(made));
}

Result<void> TaskedApplication::add(const TaskModel& model) {
  const auto& body = description_.body;
  const TaskSetting setting{truth_->truth_channels(), terrain(), body ? std::optional(body->radius_m) : std::nullopt};
  Set set{model.id, hash_name(model.id), 0, model.kind->descriptor.ports.size(), {}};
  for (const PortDescriptor& port : model.kind->descriptor.ports) set.values += static_cast<std::size_t>(port.width());
  for (int robot = 0; robot < robots(); ++robot) {
    auto task = model.kind->make(model.parameters);
    if (!task) return tl::unexpected<Error>(task.error());
    if (auto settled = (*task)->settle(setting); !settled) return settled;
    set.tasks.push_back(std::move(*task));
  }
  for (const InterventionDescriptor& one : set.tasks.front()->interventions()) {
    if (find(interventions_, one.name) == nullptr) interventions_.push_back(one);
  }
  sets_.push_back(std::move(set));
  return {};
}

Outlook TaskedApplication::outlook(int robot) const noexcept {
  return {tick_, truth_->time_s(), truth_->truth_of(robot), terrain()};
}

Result<void> TaskedApplication::reset(std::uint64_t seed, std::uint32_t episode) {
  set_ = false;
  if (auto done = inner_->reset(seed, episode); !done) return done;
  tick_ = 0;
  for (int robot = 0; robot < robots(); ++robot) {
    for (Set& set : sets_) {
      const StreamId stream{seed, episode, static_cast<std::uint32_t>(robot),
                            combine(set.name_hash, hash_name("reset"))};
      auto begun = set.tasks[static_cast<std::size_t>(robot)]->begin(outlook(robot), Draws(stream, 0));
      if (!begun) return begun;
    }
  }
  set_ = true;
  judge();
  return {};
}

void TaskedApplication::judge() noexcept {
  if (!set_) return;
  for (int robot = 0; robot < robots(); ++robot) {
    const Outlook now = outlook(robot);
    for (Set& set : sets_) set.tasks[static_cast<std::size_t>(robot)]->judge(now);
  }
}

void TaskedApplication::sense(std::span<SenseFrame> frames) noexcept {
  inner_->sense(frames);
  for (std::size_t robot = 0; robot < frames.size(); ++robot) {
    const Outlook now = outlook(static_cast<int>(robot));
    auto values = std::span(frames[robot].values).subspan(own_values_);
    std::fill(values.begin(), values.end(), std::numeric_limits<double>::quiet_NaN());
    for (const Set& set : sets_) {
      if (!set_) break;
      set.tasks[robot]->tell(now, values.first(set.values));
      values = values.subspan(set.values);
    }
    std::fill(frames[robot].ages_s.begin() + static_cast<std::ptrdiff_t>(own_channels_), frames[robot].ages_s.end(), 0);
  }
}

void TaskedApplication::step(std::span<const ActFrame> frames, double step_s) noexcept {
  for (std::size_t robot = 0; robot < frames.size(); ++robot) {
    for (Set& set : sets_) set.tasks[robot]->hear(frames[robot]);
  }
  inner_->step(frames, step_s);
  ++tick_;
  judge();
}

Result<Intervened> TaskedApplication::intervene(const Intervention& what) {
  if (what.robot < 0 || what.robot >= robots()) {
    return fail(ErrorCode::NotFound,
                {"there is no robot {}: they are numbered from 0 to {}", "no existe el robot {}: se numeran de 0 a {}"},
                what.robot, robots() - 1);
  }
  if (!set_) {
    return fail(ErrorCode::Unsupported,
                {"the tasks have not begun: reset first", "las tareas no han empezado: reinicie antes"});
  }
  for (Set& set : sets_) {
    Task& task = *set.tasks[static_cast<std::size_t>(what.robot)];
    const InterventionDescriptor* descriptor = find(task.interventions(), what.name);
    if (descriptor == nullptr) continue;
    const auto arguments = arguments_of(*descriptor, what);
    if (!arguments) return tl::unexpected<Error>(arguments.error());
    return task.intervene(outlook(what.robot), *descriptor, *arguments);
  }
  return inner_->intervene(what);
}

const Ledger* TaskedApplication::ledger(int robot, std::string_view task) const noexcept {
  for (const Set& set : sets_) {
    if (set.id == task) return set.tasks[static_cast<std::size_t>(robot)]->ledger();
  }
  return truth_->ledger(robot, task);
}

}  // namespace ganglion
