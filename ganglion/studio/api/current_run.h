#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "ganglion/studio/api/ask.h"
#include "ganglion/studio/api/hooks.h"
#include "ganglion/studio/live/run_session.h"

namespace ganglion::studio {

/// The one run there is at a time: the studio's own, or one of the command line that is only watched.
class CurrentRun {
 public:
  CurrentRun(OnHub on_hub, Later later) : on_hub_(std::move(on_hub)), later_(std::move(later)) {}
  CurrentRun(const CurrentRun&) = delete;
  CurrentRun& operator=(const CurrentRun&) = delete;

  /// A run that belongs to the command line takes the place.
  void attach(Json state) { attached_ = std::move(state); }

  /// Ends the run before it. All viewers watch the new one from now on.
  void begin(std::shared_ptr<const Prepared> prepared, RunPlan plan);
  /// Begins what was prepared for the last one again. There must have been one.
  void begin_again(RunPlan plan) { begin(prepared_, std::move(plan)); }
  /// Stops the run and waits for its end; what it was begun with. None where there is none.
  std::optional<RunPlan> end();

  /// Null where none was begun, or the last one taken away by end().
  RunSession* session() const noexcept { return session_.get(); }
  bool is_on() const { return session_ && !session_->over(); }
  /// Of the last run that was begun, from 1 on; 0 = none was.
  std::uint64_t number() const noexcept { return number_; }

  /// docs/studio_api.md, RunState.
  Json state() const;
  /// Where the run cannot be commanded from here.
  std::optional<Reply> refuse_command(const Ask&) const;
  /// The answer to a command: the state, or that no run is on.
  Reply answer(const Ask&, bool done) const;
  /// The answer to a command that began a run.
  Reply begun() const;

 private:
  void tell_state();

  const OnHub on_hub_;
  const Later later_;
  Json attached_;
  std::shared_ptr<const Prepared> prepared_;
  std::uint64_t number_ = 0;
  std::unique_ptr<RunSession> session_;
};

}  // namespace ganglion::studio
