#include "ganglion/run/run.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <thread>

#include "ganglion/application/fault/faulty_application.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/run/recording.h"
#include "ganglion/run/robot_measures.h"
#include "ganglion/run/run_robots.h"

namespace ganglion {
namespace {

using Controllers = std::vector<std::unique_ptr<Controller>>;

/// Holds a run to a multiple of real time, between ticks; the run itself knows nothing of it.
class Pace {
 public:
  explicit Pace(double factor) : factor_(factor), start_(std::chrono::steady_clock::now()) {}
  void wait_until(double time_s) const {
    if (factor_ > 0) std::this_thread::sleep_until(start_ + std::chrono::duration<double>(time_s / factor_));
  }

 private:
  double factor_;
  std::chrono::steady_clock::time_point start_;
};

Result<Controllers> make_controllers(const Prepared& prepared, const RunOptions& options) {
  Controllers controllers;
  for (int robot = 0; robot < prepared.experiment.robots; ++robot) {
    const Identity identity{options.seed, options.episode, static_cast<std::uint32_t>(robot)};
    auto made = Controller::compile(prepared.controller, prepared.robot->description, controller_kinds(), identity);
    if (!made) return tl::unexpected<Error>(made.error());
    controllers.push_back(std::make_unique<Controller>(std::move(*made)));
    Problems problems;
    controllers.back()->load(options.experience, problems);
    if (!problems.empty()) return tl::unexpected<Error>(problems.sorted().front());
  }
  return controllers;
}

/// One run as it goes: application, controllers, frames between them.
class Course {
 public:
  Course(const Prepared& prepared, RunRobots robots, std::unique_ptr<FaultyApplication> application,
         Controllers controllers)
      : step_s_(prepared.step_s),
        robots_(std::move(robots)),
        application_(std::move(application)),
        controllers_(std::move(controllers)) {
    const RobotDescription& description = prepared.robot->description;
    sense_.assign(controllers_.size(), make_sense_frame(description));
    act_.assign(controllers_.size(), make_act_frame(description));
    for (std::size_t i = 0; i < controllers_.size(); ++i) {
      if (witness() != nullptr) truth_digests_.push_back(truth_.join(static_cast<std::uint32_t>(i), "@truth"));
    }
  }

  /// A frame to every controller, a frame back.
  void decide() noexcept {
    application_->sense(sense_);
    for (std::size_t i = 0; i < controllers_.size(); ++i) {
      make_canonical(sense_[i]);
      controllers_[i]->tick(sense_[i], step_s_, act_[i]);
      make_canonical(act_[i]);
      if (witness() == nullptr) continue;
      const sim::Truth& truth = witness()->truth(static_cast<int>(i));
      const std::array<double, 4> bits = {truth.pose.position.x, truth.pose.position.y, truth.pose.yaw.rad(),
                                          truth.energy_J};
      truth_.add(truth_digests_[i], sense_[i].tick, bits);
    }
  }
  /// The commands are carried out; controllers may grow meanwhile.
  void act() {
    application_->step(act_, step_s_);
    for (const auto& controller : controllers_) controller->grow();
  }

  std::uint32_t tick() const noexcept { return sense_.front().tick; }
  double time_s() const noexcept { return sense_.front().time_s; }
  const RunRobots& robots() const noexcept { return robots_; }
  const sim::Witness* witness() const noexcept { return robots_.witness(); }
  /// Of the first robot's trainer; null where there is none.
  const sim::TrainerLog* trainer() const noexcept { return witness() != nullptr ? witness()->trainer_log(0) : nullptr; }
  const Controllers& controllers() const noexcept { return controllers_; }
  std::string digest(const Interference& interference) const {
    std::uint64_t sum = truth_.total();
    if (interference.count() > 0) sum += interference.digest().total();
    for (const auto& controller : controllers_) sum += controller->digest().total();
    return hex(sum);
  }
  std::vector<std::pair<std::string, std::string>> component_digests(const Interference& interference) const {
    std::vector<std::pair<std::string, std::string>> result;
    const auto tell = [&result](const Digest& digest) {
      for (const Digest::OfComponent& one : digest.components()) {
        if (one.robot >= kDigestedRobots) continue;
        result.emplace_back(fmt::format("robot{}/{}", one.robot, one.component), hex(one.value));
      }
    };
    tell(truth_);
    for (const auto& controller : controllers_) tell(controller->digest());
    tell(interference.digest());
    return result;
  }

 private:
  double step_s_;
  RunRobots robots_;
  std::unique_ptr<FaultyApplication> application_;  // of the robots
  Controllers controllers_;
  std::vector<SenseFrame> sense_;
  std::vector<ActFrame> act_;
  Digest truth_;
  std::vector<std::size_t> truth_digests_;
};

Result<Course> make_course(const Prepared& prepared, const RunOptions& options, Result<RunRobots> robots) {
  if (!robots) return tl::unexpected<Error>(robots.error());
  auto faulty = FaultyApplication::make(robots->application(), prepared.experiment.faults, prepared.step_s);
  if (!faulty) return tl::unexpected<Error>(faulty.error());
  if (auto reset = (*faulty)->reset(options.seed, options.episode); !reset) {
    return tl::unexpected<Error>(reset.error());
  }
  auto controllers = make_controllers(prepared, options);
  if (!controllers) return tl::unexpected<Error>(controllers.error());
  return Course(prepared, std::move(*robots), std::move(*faulty), std::move(*controllers));
}

std::uint32_t ticks_of(const Prepared& prepared) {
  return static_cast<std::uint32_t>(std::max(1.0, std::round(prepared.experiment.duration_s / prepared.step_s)));
}

/// Progress along the course that the same robots, faults included, make from the same poses where nothing stands in
/// their way.
Result<std::vector<FreeGround>> drive_free_ground(const Prepared& prepared, const RunOptions& options,
                                                  const std::vector<Pose2>& starts) {
  auto course = make_course(prepared, options, RunRobots::simulate(prepared, prepared.open_ground, starts));
  if (!course) return tl::unexpected<Error>(course.error());
  std::vector<FreeGround> progress(starts.size());
  const std::uint32_t ticks = ticks_of(prepared);
  for (std::uint32_t tick = 0; tick < ticks; ++tick) {
    course->decide();
    course->act();
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const Vector2 way = course->witness()->truth(static_cast<int>(i)).pose.position - starts[i].position;
      const double along_m = way.dot(direction(starts[i].yaw.rad()));
      progress[i].push_back(std::max(along_m, tick > 0 ? progress[i].back() : 0));
    }
    if (options.stop && options.stop()) break;  // the run itself will see it too
  }
  return progress;
}

/// The same from where these robots start; nothing where there is no such ground, or nobody knows where they are.
Result<std::vector<FreeGround>> free_ground_of(const Prepared& prepared, const RunOptions& options,
                                               const Course& course) {
  if (prepared.open_ground == nullptr || !prepared.robot->simulated() || course.witness() == nullptr) {
    return std::vector<FreeGround>{};
  }
  std::vector<Pose2> starts;
  for (int i = 0; i < prepared.experiment.robots; ++i) starts.push_back(course.witness()->truth(i).pose);
  return drive_free_ground(prepared, options, starts);
}

/// What is measured of all robots.
class Judge {
 public:
  Judge(const Prepared& prepared, const Course& course, std::vector<FreeGround> free_ground)
      : prepared_(prepared), free_ground_(std::move(free_ground)) {
    for (std::size_t i = 0; i < course.controllers().size(); ++i) {
      robots_.emplace_back(*prepared.ground, truth_of(course, i), prepared.robot->radius_m, *course.controllers()[i],
                           free_ground_.empty() ? nullptr : &free_ground_[i]);
    }
  }
  void update(const Course& course, double time_s) {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      robots_[i].update(time_s, prepared_.step_s, truth_of(course, i), course.controllers()[i]->values());
    }
  }
  Measures measures(const Course& course) const {
    Measures measures;
    robots_.front().report(measures);
    if (const sim::TrainerLog* trainer = course.trainer()) report_goals(trainer->records(), measures);
    return measures;
  }
  /// The stop rule that is met, or "".
  std::string stopped(const Course& course) const {
    const sim::TrainerLog* trainer = course.trainer();
    const Measures cheap = {{"at_far_wall", robots_.front().at_far_wall() ? 1 : 0},
                            {"goals_done", trainer != nullptr && trainer->done() ? 1 : 0},
                            {"progress_m", robots_.front().progress_m()}};
    for (const Criterion& criterion : prepared_.experiment.stop) {
      if (criterion.met(cheap)) return criterion.text();
    }
    return "";
  }

 private:
  static const sim::Truth* truth_of(const Course& course, std::size_t robot) {
    return course.witness() != nullptr ? &course.witness()->truth(static_cast<int>(robot)) : nullptr;
  }

  const Prepared& prepared_;
  std::vector<FreeGround> free_ground_;
  std::vector<RobotMeasures> robots_;
};

void judge(const Experiment& experiment, RunResult& result) {
  result.success = result.reason.en != kInterrupted.in(Language::English) && !result.link_lost;
  if (result.interventions > 0) {
    result.reason += say({"; interventions: {}", "; intervenciones: {}"}, result.interventions);
  }
  for (const Criterion& criterion : experiment.success) {
    if (criterion.met(result.measures)) continue;
    result.success = false;
    const double found = measure(result.measures, criterion.name);
    const Sentence about = std::isnan(found) ? say({"not available", "no disponible"})
                                             : say({"{:.4g}", "{:.4g}"}, found);  // the measures have all digits
    result.reason += say({"; not met: {} ({})", "; no se cumple: {} ({})"}, criterion.text(), about);
  }
}

Contacts contacts_of(const Course& course, int robots) {
  Contacts contacts{.known = course.witness() != nullptr};
  for (int i = 0; i < robots && contacts.known; ++i) {
    const sim::Truth& truth = course.witness()->truth(i);
    contacts.count += truth.contacts;
    contacts.fastest_mps = std::max(contacts.fastest_mps, truth.fastest_contact_mps);
  }
  return contacts;
}

void tell_digests(const Course& course, const Interference& interference, RunResult& result) {
  result.digest = course.digest(interference);
  result.component_digests = course.component_digests(interference);
  result.interventions = interference.count();
}

std::size_t concluded_goals(const Course& course) {
  const sim::TrainerLog* trainer = course.trainer();
  if (trainer == nullptr) return 0;
  const auto goals = trainer->records();
  return static_cast<std::size_t>(std::count_if(
      goals.begin(), goals.end(), [](const sim::GoalRecord& goal) { return goal.outcome != sim::GoalOutcome::Open; }));
}

}  // namespace

Result<RunResult> run(const Prepared& prepared, const RunOptions& options) {
  auto course = make_course(prepared, options, RunRobots::make(prepared, options));
  if (!course) return tl::unexpected<Error>(course.error());
  auto free_ground = free_ground_of(prepared, options, *course);
  if (!free_ground) return tl::unexpected<Error>(free_ground.error());
  Judge measured(prepared, *course, std::move(*free_ground));
  auto recording = Recording::start(prepared, options, course->robots(), course->controllers());
  if (!recording) return tl::unexpected<Error>(recording.error());
  Interference interference(course->robots().simulation(), options.interventions, [&](const TimedIntervention& one) {
    recording->write_intervention(one, one.tick * prepared.step_s);
  });
  if (options.reach) options.reach([&](const sim::Intervention& what) { return interference.reach(what); });
  if (auto done = interference.before(0); !done) return tl::unexpected<Error>(done.error());

  RunResult result;
  result.seed = options.seed;
  result.reason = say({"duration over", "se acabó el tiempo"});
  const bool begins = !options.armed || options.armed();
  if (!begins) result.reason = say({"{}", "{}"}, kInterrupted);
  const Pace pace(options.pace);
  const std::uint32_t ticks = begins ? ticks_of(prepared) : 0;
  std::size_t goals = 0;
  for (std::uint32_t tick = 0; tick < ticks; ++tick) {
    course->decide();
    recording->write(course->tick(), course->time_s());
    course->act();
    if (const Error* lost = course->robots().application().failure()) {
      result.link_lost = *lost;
      result.reason = say({"{}: {}", "{}: {}"}, kLinkLost, lost->what);
      break;
    }
    const double time_s = (tick + 1) * prepared.step_s;
    measured.update(*course, time_s);
    if (const std::size_t now = concluded_goals(*course); options.learned && now != goals) {
      goals = now;
      options.learned(course->controllers().front()->experience());
    }
    if (const std::string stop = measured.stopped(*course); !stop.empty()) {
      result.reason = say({"stopped: {}", "parada: {}"}, stop);
      break;
    }
    if (auto done = interference.before(tick + 1); !done) return tl::unexpected<Error>(done.error());
    const bool wanted = !options.progress || options.progress((tick + 1.0) / ticks);
    if (!wanted || (options.stop && options.stop())) {
      result.reason = say({"{}", "{}"}, kInterrupted);
      break;
    }
    if (!course->robots().free_running()) pace.wait_until(time_s);
  }
  result.measures = measured.measures(*course);
  result.contacts = contacts_of(*course, prepared.experiment.robots);
  tell_digests(*course, interference, result);
  result.experience = course->controllers().front()->experience();
  judge(prepared.experiment, result);
  if (options.learned) options.learned(result.experience);
  if (auto finished = recording->finish(result); !finished) result.record_error = finished.error();
  return result;
}

}  // namespace ganglion
