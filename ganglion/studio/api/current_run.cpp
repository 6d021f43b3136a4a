#include "ganglion/studio/api/current_run.h"

namespace ganglion::studio {

void CurrentRun::begin(std::shared_ptr<const Prepared> prepared, RunPlan plan) {
  prepared_ = std::move(prepared);
  session_.reset();
  const auto changed = [this] { later_([this] { tell_state(); }); };
  session_ = std::make_unique<RunSession>(std::to_string(++number_), prepared_, std::move(plan), changed);
  on_hub_([feed = session_->feed()](Hub& hub) { hub.watch(feed); });
  tell_state();
}

std::optional<RunPlan> CurrentRun::end() {
  if (!session_) return std::nullopt;
  RunPlan plan = session_->plan();
  session_.reset();
  return plan;
}

Json CurrentRun::state() const {
  if (!attached_.is_null()) return attached_;
  return session_ ? session_->state() : Json{{"state", "idle"}};
}

void CurrentRun::tell_state() {
  on_hub_([state = state()](Hub& hub) mutable { hub.set_state(std::move(state)); });
}

std::optional<Reply> CurrentRun::refuse_command(const Ask& ask) const {
  if (attached_.is_null()) return std::nullopt;
  return ask.refuse("Forbidden",
                    say({"this run belongs to the command line; it can only be watched",
                         "esta ejecución es de la línea de órdenes; solo se puede mirar"}),
                    403);
}

Reply CurrentRun::answer(const Ask& ask, bool done) const {
  if (!done) return ask.refuse("NotRunning", say({"no run is on", "no hay ninguna ejecución"}), 409);
  return json_reply({{"state", state()}});
}

Reply CurrentRun::begun() const { return json_reply({{"run", std::to_string(number_)}, {"state", state()}}); }

}  // namespace ganglion::studio
