#include "ganglion/studio/api/run_routes.h"

#include <algorithm>

#include "ganglion/studio/api/run_plan.h"

namespace ganglion::studio {

RunRoutes::RunRoutes(Router& router, const Folder& folder, const WantedReader& wanted, CurrentRun& run)
    : folder_(folder), wanted_(wanted), run_(run) {
  router.get("/api/run", [this](const Ask&) { return json_reply(run_.state()); });
  router.post("/api/run/start", [this](const Ask& ask) { return start(ask); });
  router.post("/api/run/pause", [this](const Ask& ask) { return command(ask, &RunSession::pause); });
  router.post("/api/run/resume", [this](const Ask& ask) { return command(ask, &RunSession::resume); });
  router.post("/api/run/step", [this](const Ask& ask) { return step(ask); });
  router.post("/api/run/stop", [this](const Ask& ask) { return command(ask, &RunSession::stop); });
  router.post("/api/run/reset", [this](const Ask& ask) { return reset(ask); });
  router.post("/api/run/pace", [this](const Ask& ask) { return set_pace(ask); });
}

Reply RunRoutes::start(const Ask& ask) {
  if (auto refused = run_.refuse_command(ask)) return *refused;
  if (run_.is_on())
    return ask.refuse("Running", say({"a run is on; stop it first", "hay una ejecución en marcha; deténgala antes"}),
                      409);
  Wanted wanted;
  if (auto refused = wanted_.read_wanted(ask, wanted)) return *refused;
  std::optional<Prepared> prepared;
  if (auto refused = wanted_.prepare_wanted(wanted, ask, prepared)) return *refused;
  auto plan = plan_of(ask, *prepared, folder_);
  if (!plan) return failure(plan.error(), ask.language);
  run_.begin(std::make_shared<const Prepared>(std::move(*prepared)), std::move(*plan));
  return run_.begun();
}

Reply RunRoutes::command(const Ask& ask, const std::function<bool(RunSession&)>& what) {
  if (auto refused = run_.refuse_command(ask)) return *refused;
  return run_.answer(ask, run_.session() != nullptr && what(*run_.session()));
}

Reply RunRoutes::step(const Ask& ask) {
  const double ticks = std::clamp(ask.number("ticks", 1), 1.0, 1e6);
  return command(ask, [&](RunSession& run) { return run.step(static_cast<std::uint32_t>(ticks)); });
}

Reply RunRoutes::set_pace(const Ask& ask) {
  if (auto refused = run_.refuse_command(ask)) return *refused;
  const double pace = ask.number("pace", -1);
  if (!(pace >= 0 && pace <= 1e6))
    return ask.refuse("BadParameter",
                      say({"pace must be a number >= 0; 0 = as fast as can be",
                           "el ritmo debe ser un número >= 0; 0 = lo más rápido posible"}),
                      400);
  if (run_.session() != nullptr) run_.session()->set_pace(pace);
  return run_.answer(ask, run_.session() != nullptr);
}

/// The same run from the start, in a new file.
Reply RunRoutes::reset(const Ask& ask) {
  if (auto refused = run_.refuse_command(ask)) return *refused;
  auto plan = run_.end();
  if (!plan) return run_.answer(ask, false);
  renew_file(*plan, run_.number() + 1);
  run_.begin_again(std::move(*plan));
  return run_.begun();
}

}  // namespace ganglion::studio
