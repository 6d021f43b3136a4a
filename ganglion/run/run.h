#pragma once

#include <functional>
#include <optional>

#include "ganglion/experience/writer.h"
#include "ganglion/graph/controller.h"
#include "ganglion/record/run_sink.h"
#include "ganglion/run/interference.h"
#include "ganglion/run/prepared.h"

namespace ganglion {

struct RunOptions {
  std::uint64_t seed = 1;
  std::uint32_t episode = 0;
  double pace = 0;                           ///< Times real time; 0 = as fast as can be.
  std::filesystem::path run_file;            ///< Empty: nothing is recorded.
  std::vector<ModuleExperience> experience;  ///< What every controller starts with.
  /// Called between ticks with the share done in [0, 1]; returns false to end the run early.
  std::function<bool(double)> progress;
  /// Asked between ticks, those of the run on open ground included; true ends the run early.
  std::function<bool()> stop;
  /// Is handed what robot 0 learns, between ticks and at the end (HandingOver); null: it is forgotten.
  ExperienceWriter* keeper = nullptr;
  /// Is told all that a run file would hold, whether there is one or not; called between ticks, by the run's own
  /// thread.
  RunSink* watcher = nullptr;
  /// Called once when all is ready, before the first tick: may hold the run back; false ends it before it begins.
  std::function<bool()> armed;
  /// What is done to the world, by tick, in order: a run that cannot do it fails. One that does is not the seed's own
  /// any more: its digest and its reason say so.
  std::vector<TimedIntervention> interventions;
  /// Called once before `armed` with a way to do more: to be used by `armed`, `progress` and their like, between ticks
  /// and by the run's own thread. What it does is done before the next tick, and recorded.
  std::function<void(Reach)> reach;
  /// Called once before `armed` with what keeps the place of the robots' commander while a run is held back: to be called
  /// each second or so by `armed` and `progress` where they wait, by the run's own thread.
  std::function<void(std::function<void()>)> in_touch;
  bool in_process = false;  ///< Simulate the robots here, whatever address the experiment names.
};

struct Contacts {
  bool known = true;  ///< False where only the robots' own sensors tell of them.
  int count = 0;
  double fastest_mps = 0;
};

/// What came of one run.
struct RunResult {
  std::uint64_t seed = 0;
  Verdict verdict = Verdict::NotJudged;  ///< NotJudged without criteria; Failed where it was interrupted.
  Sentence reason;                       ///< "duration over", and the criteria that were not met.
  std::string digest;
  /// Of each component alone, "robot0/escape", and of each robot's way, "robot0/@truth"; of the first kDigestedRobots.
  std::vector<std::pair<std::string, std::string>> component_digests;
  Contacts contacts;  ///< Of all robots.
  Measures measures;  ///< Of robot 0; with several robots the worst of each is not taken: see docs/manual/run.md.
  std::vector<std::string> files;
  std::size_t interventions = 0;          ///< How often somebody reached into its world.
  std::optional<Error> link_lost;         ///< The run ended early for it.
  std::optional<Error> record_error;      ///< The run was carried out, but its file is not whole.
  std::optional<Error> experience_error;  ///< The same; the end of what it learned is not kept.
};

/// Carries out one run. Fails where a component refuses its parameters, the robot finds no place, or the file cannot be
/// made. A disk that fills up on the way loses the file's end, not the result. The result depends on the experiment,
/// the experience, the interventions and the seed only; that of an interrupted run also on when it was.
Result<RunResult> run(const Prepared& prepared, const RunOptions& options);

/// Makes what a run begins with, with the experiment's own seed, up to its first tick: fails as run() would for what
/// stands in the files. The controller was made once by prepare(), and is not made again for each robot. Robots
/// elsewhere are not asked.
Result<void> try_start(const Prepared& prepared);

/// The reason of a run that `progress` or `stop` ended, before the criteria it did not meet.
inline constexpr Text kInterrupted{"interrupted", "interrumpida"};
/// The same of one whose robots could not be reached any more; what happened follows.
inline constexpr Text kLinkLost{"link lost", "enlace perdido"};

/// Robots whose components' digests a run tells one by one: enough to compare by, and no burden on a swarm's run file.
inline constexpr std::uint32_t kDigestedRobots = 100;

/// Name of the experience a run started from, among the attachments of its file.
inline constexpr std::string_view kExperienceAttachment = "experience";

}  // namespace ganglion
