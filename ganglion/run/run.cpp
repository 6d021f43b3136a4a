#include "ganglion/run/run.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <thread>

#include "ganglion/application/fault/faulty_application.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/run/bounds.h"
#include "ganglion/run/handing_over.h"
#include "ganglion/run/measure_list.h"
#include "ganglion/run/recording.h"
#include "ganglion/run/run_robots.h"

namespace ganglion {
namespace {

using Controllers = std::vector<std::unique_ptr<Controller>>;

/// Holds a run to a multiple of real time, between ticks; the run itself knows nothing of it.
class Pace {
 public:
  Pace(double factor, std::function<void()> in_touch)
      : factor_(factor), in_touch_(std::move(in_touch)), start_(std::chrono::steady_clock::now()) {}
  /// In a long wait the robots are kept in touch with. stop() ends it.
  void wait_until(double time_s, const std::function<bool()>& stop) const {
    if (factor_ <= 0) return;
    const auto end = start_ + std::chrono::duration<double>(time_s / factor_);
    while (std::chrono::steady_clock::now() + kInTouch < end && !(stop && stop())) {
      std::this_thread::sleep_for(kInTouch);
      in_touch_();
    }
    if (!(stop && stop())) std::this_thread::sleep_until(end);
  }

 private:
  static constexpr std::chrono::milliseconds kInTouch{500};
  double factor_;
  std::function<void()> in_touch_;
  std::chrono::steady_clock::time_point start_;
};

Result<Controllers> make_controllers(const Prepared& prepared, const RunOptions& options) {
  Controllers controllers;
  for (int robot = 0; robot < prepared.experiment.robots; ++robot) {
    const Identity identity{options.seed, options.episode, static_cast<std::uint32_t>(robot)};
    auto made =
        Controller::compile(prepared.controller, prepared.application->description(), controller_kinds(), identity);
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
    const Description& description = prepared.application->description();
    sense_.assign(controllers_.size(), make_sense_frame(description));
    act_.assign(controllers_.size(), make_act_frame(description));
    for (std::size_t i = 0; i < controllers_.size(); ++i) {
      if (witness() != nullptr) truth_digests_.push_back(truth_.join(static_cast<std::uint32_t>(i), "@truth"));
    }
    for (const LedgerForm& form : prepared.application->ledgers()) {
      ledgers_.push_back(witness() != nullptr ? witness()->ledger(0, form.task) : nullptr);
    }
    if (witness() == nullptr) return;
    const auto channels = witness()->truth_channels();
    for (std::size_t n = 0; n < channels.size(); ++n) {
      if (channels[n].digested) digested_.push_back(n);
    }
    digested_truth_.resize(digested_.size());
  }

  /// A frame to every controller, a frame back.
  void decide() noexcept {
    application_->sense(sense_);
    for (std::size_t i = 0; i < controllers_.size(); ++i) {
      make_canonical(sense_[i]);
      controllers_[i]->tick(sense_[i], step_s_, act_[i]);
      make_canonical(act_[i]);
      if (witness() == nullptr) continue;
      const auto truth = witness()->truth_of(static_cast<int>(i));
      for (std::size_t n = 0; n < digested_.size(); ++n) digested_truth_[n] = truth[digested_[n]];
      truth_.add(truth_digests_[i], sense_[i].tick, digested_truth_);
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
  void name_output(const std::filesystem::path& run_file) { robots_.name_output(run_file); }
  /// Null where nobody knows the truth.
  const Witness* witness() const noexcept { return robots_.witness(); }
  /// What tasks keep of robot 0, in the order of the application's model; null where nobody knows it.
  std::span<const Ledger* const> ledgers() const noexcept { return ledgers_; }
  /// The present instant as measures of robot 0 see it.
  Moment moment(double time_s) const noexcept {
    return {.time_s = time_s,
            .step_s = step_s_,
            .truth = witness() != nullptr ? witness()->truth_of(0) : std::span<const double>(),
            .signals = controllers_.front()->values(),
            .ledgers = ledgers_};
  }
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
  std::vector<std::size_t> digested_;   // channels of the truth
  std::vector<double> digested_truth_;  // of one robot
  std::vector<const Ledger*> ledgers_;
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

/// The truth of robot 0 where the same application, faults included, begins as this one and nothing stands in its way;
/// nothing where it is not asked for, or there is no such.
Result<std::optional<Unhindered>> unhindered_of(const Prepared& prepared, const RunOptions& options,
                                                const Course& course) {
  if (!prepared.experiment.free_ground) return std::optional<Unhindered>();
  auto application = prepared.application->unhindered(course.robots().application());
  if (!application) return tl::unexpected<Error>(application.error());
  if (*application == nullptr) return std::optional<Unhindered>();
  auto other = make_course(prepared, options, RunRobots::make_here(std::move(*application)));
  if (!other) return tl::unexpected<Error>(other.error());
  Unhindered free{.channels = other->witness()->truth_channels().size()};
  const auto ticks = static_cast<std::uint32_t>(ticks_of(prepared));
  for (std::uint32_t tick = 0; tick < ticks; ++tick) {
    other->decide();
    other->act();
    const auto truth = other->witness()->truth_of(0);
    free.values.insert(free.values.end(), truth.begin(), truth.end());
    if (options.stop && options.stop()) break;  // the run itself will see it too
  }
  return std::optional<Unhindered>(std::move(free));
}

/// The stop rules of an experiment, looked at after every step.
class StopRules {
 public:
  explicit StopRules(const std::vector<Criterion>& rules) : rules_(&rules) {
    for (const Criterion& rule : rules) {
      figures_.push_back(rule.name);
      if (!rule.times.empty()) figures_.push_back(rule.times);
    }
  }
  /// The first that is met, or null.
  const Criterion* met(const MeasureList& measured) const {
    if (rules_->empty()) return nullptr;
    const Measures now = measured.of(figures_);
    const auto found = std::ranges::find_if(*rules_, [&now](const Criterion& rule) { return rule.met(now); });
    return found != rules_->end() ? &*found : nullptr;
  }

 private:
  const std::vector<Criterion>* rules_;
  std::vector<std::string> figures_;
};

void judge(const Experiment& experiment, RunResult& result) {
  const bool whole = result.reason.en != kInterrupted.in(Language::English) && !result.link_lost;
  result.verdict = !whole ? Verdict::Failed : experiment.success.empty() ? Verdict::NotJudged : Verdict::Succeeded;
  if (result.interventions > 0) {
    result.reason += say({"; interventions: {}", "; intervenciones: {}"}, result.interventions);
  }
  for (const Criterion& criterion : experiment.success) {
    if (criterion.met(result.measures)) continue;
    result.verdict = Verdict::Failed;
    const double found = measure(result.measures, criterion.name);
    const Sentence about = std::isnan(found) ? say({"not available", "no disponible"})
                                             : say({"{:.4g}", "{:.4g}"}, found);  // the measures have all digits
    result.reason += say({"; not met: {} ({})", "; no se cumple: {} ({})"}, criterion.text(), about);
  }
}

Contacts contacts_of(const Course& course, const Prepared& prepared) {
  const auto count = prepared.scope().truth_index("contacts"),
             fastest = prepared.scope().truth_index("fastest_contact_mps");
  Contacts contacts{.known = course.witness() != nullptr && count && fastest};
  for (int i = 0; i < prepared.experiment.robots && contacts.known; ++i) {
    const auto truth = course.witness()->truth_of(i);
    contacts.count += static_cast<int>(truth[*count]);
    contacts.fastest_mps = std::max(contacts.fastest_mps, truth[*fastest]);
  }
  return contacts;
}

/// What came of a run that is over.
void tell(const Course& course, const Prepared& prepared, const MeasureList& measured, const Interference& interference,
          RunResult& result) {
  result.measures = measured.listed();
  result.contacts = contacts_of(course, prepared);
  result.digest = course.digest(interference);
  result.component_digests = course.component_digests(interference);
  result.interventions = interference.count();
  judge(prepared.experiment, result);
}

}  // namespace

Result<void> try_start(const Prepared& prepared) {
  if (prepared.experiment.link.remote()) return {};
  const auto robots = RunRobots::make(prepared, {});
  if (!robots) return tl::unexpected<Error>(robots.error());
  auto faulty = FaultyApplication::make(robots->application(), prepared.experiment.faults, prepared.step_s);
  if (!faulty) return tl::unexpected<Error>(faulty.error());
  return (*faulty)->reset(prepared.experiment.seed, 0);
}

Result<RunResult> run(const Prepared& prepared, const RunOptions& options) {
  auto course = make_course(prepared, options, RunRobots::make(prepared, options));
  if (!course) return tl::unexpected<Error>(course.error());
  auto free_ground = unhindered_of(prepared, options, *course);
  if (!free_ground) return tl::unexpected<Error>(free_ground.error());
  MeasureList measured(prepared.scope());
  measured.begin(course->moment(0), *free_ground ? &**free_ground : nullptr);
  auto recording = Recording::start(prepared, options, course->robots(), course->controllers());
  if (!recording) return tl::unexpected<Error>(recording.error());
  Interference interference(course->robots().here(), options.interventions,
                            [&](const auto& descriptor, const auto& one) {
                              recording->write_intervention(descriptor, one, one.tick * prepared.step_s);
                            });
  if (options.reach) options.reach([&](const Intervention& what) { return interference.reach(what); });
  const std::function<void()> in_touch = [remote = course->robots().remote()] {
    if (remote != nullptr) remote->stay_in_touch();
  };
  if (options.in_touch) options.in_touch(in_touch);
  if (auto done = interference.before(0); !done) return tl::unexpected<Error>(done.error());

  RunResult result;
  result.seed = options.seed;
  result.reason = say({"duration over", "se acabó el tiempo"});
  const bool begins = !options.armed || options.armed();
  if (!begins) result.reason = say({"{}", "{}"}, kInterrupted);
  const Pace pace(options.pace, in_touch);
  const auto ticks = static_cast<std::uint32_t>(begins ? ticks_of(prepared) : 0);
  HandingOver handing_over(options.keeper, *course->controllers().front());
  const StopRules stop(prepared.experiment.stop);
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
    measured.update(course->moment(time_s));
    handing_over.between_ticks();
    if (const Criterion* rule = stop.met(measured)) {
      result.reason = say({"stopped: {}", "parada: {}"}, rule->text());
      break;
    }
    if (auto done = interference.before(tick + 1); !done) return tl::unexpected<Error>(done.error());
    const bool wanted = !options.progress || options.progress((tick + 1.0) / ticks);
    if (!wanted || (options.stop && options.stop())) {
      result.reason = say({"{}", "{}"}, kInterrupted);
      break;
    }
    if (!course->robots().free_running()) pace.wait_until(time_s, options.stop);
  }
  tell(*course, prepared, measured, interference, result);
  if (auto kept = handing_over.conclude(); !kept) result.experience_error = kept.error();
  if (auto finished = recording->finish(result); !finished) result.record_error = finished.error();
  if (!result.files.empty()) course->name_output(result.files.front());
  return result;
}

}  // namespace ganglion
