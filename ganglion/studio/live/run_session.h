#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>

#include "ganglion/base/file_handle.h"
#include "ganglion/lab/carry_out.h"
#include "ganglion/studio/live/feed.h"

namespace ganglion::studio {

using Json = nlohmann::ordered_json;

/// What the page says of a run besides what the run file will.
struct RunPlan {
  std::string experiment;  ///< Path, from the folder on.
  std::string controller;
  std::uint64_t seed = 1;
  double pace = 1;                 ///< Times real time; 0 = as fast as can be.
  bool paused = false;             ///< Waits before the first tick.
  std::filesystem::path run_file;  ///< Empty: not recorded.
  std::string run_name;            ///< The same from the folder on.
  /// Held open while run_file leads through it, so that no link that is put in its place leads the run out.
  std::shared_ptr<const FileHandle> run_folder;
  Language language = Language::English;  ///< Of the report.
};

/// One run on a thread of its own, which can be paused, stepped and stopped between ticks. Commands may come from any
/// thread; watching never slows it down.
class RunSession {
 public:
  /// `changed` is called, by the run's thread or the caller's, whenever state() says something new; state() itself must
  /// then be asked from elsewhere.
  RunSession(std::string id, std::shared_ptr<const Prepared> prepared, RunPlan plan, std::function<void()> changed);
  /// Stops it and waits for its end.
  ~RunSession();
  RunSession(const RunSession&) = delete;
  RunSession& operator=(const RunSession&) = delete;

  /// False where the run is over already.
  bool pause();
  bool resume();
  /// Carries out so many ticks, then pauses.
  bool step(std::uint32_t ticks);
  bool stop();
  /// Of a run that is over as well: should it be started again, it goes at that pace.
  void set_pace(double pace);
  bool over() const;
  /// Has something done to the running world before its next tick, also while the run is held, and waits until that is
  /// done or refused. None where no tick will come. Fails with what the simulation says, with TooLarge where too many
  /// others wait, or with BadParameter where the present tick takes too long.
  std::optional<Result<Intervened>> intervene(const Intervention& what);

  /// docs/studio_api.md, RunState.
  Json state() const;
  const std::shared_ptr<LiveFeed>& feed() const noexcept { return feed_; }
  const RunPlan& plan() const noexcept { return plan_; }

 private:
  using Clock = std::chrono::steady_clock;

  void carry_out();
  bool between_ticks(double share);
  bool wait(std::unique_lock<std::mutex>& lock);
  void hold(std::unique_lock<std::mutex>& lock, Clock::time_point until);
  std::string run_name(const lab::Outcome& outcome) const;
  Error named(Error error) const;
  void conclude(const Result<lab::Outcome>& outcome);
  template <class Change>
  bool change(Change&& what);
  /// An intervention that somebody waits for.
  struct Wish {
    const Intervention* what;
    std::optional<Result<Intervened>> answer;
    bool too_late = false;  ///< No tick will come; there is no answer then.
  };
  void grant(std::unique_lock<std::mutex>& lock);
  void refuse_wishes();

  const std::string id_;
  const std::shared_ptr<const Prepared> prepared_;
  RunPlan plan_;
  const std::function<void()> changed_;
  const std::shared_ptr<LiveFeed> feed_ = std::make_shared<LiveFeed>();

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::string phase_ = "preparing";
  bool stop_ = false;
  bool paused_ = false;
  std::uint32_t steps_ = 0;
  Reach reach_;
  std::function<void()> in_touch_;  ///< Of the run's thread, as is reach_.
  Clock::time_point touched_{};     ///< When that was last called.
  bool reachable_ = false;          ///< The run's thread comes by for wishes.
  std::deque<Wish*> wishes_;        ///< Not taken yet; each belongs to who waits for it.
  std::condition_variable answered_;
  double share_ = 0;
  Clock::time_point due_{};  ///< When the next tick may begin.
  Clock::time_point measured_at_{};
  double measured_share_ = 0;
  double speed_ = 0;  ///< Times real time, over the last half second or so.
  Json outcome_;
  std::thread thread_;  ///< Last: it uses all of these.
};

/// The outcome as the page is told.
Json outcome_json(const lab::Outcome& outcome, const std::string& file);

}  // namespace ganglion::studio
