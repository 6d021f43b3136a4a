#include "ganglion/studio/api/link_routes.h"

#include "ganglion/kinds/applications.h"

namespace ganglion::studio {

LinkRoutes::LinkRoutes(Router& router, const Folder& folder, const WantedReader& wanted, OnHub on_hub)
    : folder_(folder), wanted_(wanted), on_hub_(std::move(on_hub)) {
  router.get("/api/link", [this](const Ask&) { return json_reply({{"test", test_ ? test_->state() : tested_}}); });
  router.post("/api/link/test", [this](const Ask& ask) { return test(ask); });
}

/// The robot that the controller is drawn for, to hold the one that is there against.
Result<LinkCheck::Subject> LinkRoutes::subject_of(const Experiment& experiment, const Ask& ask) const {
  LinkCheck::Subject subject;
  subject.address = experiment.link.address;
  subject.program = experiment.link.program;
  subject.folder = experiment.files.experiment.empty() ? folder_.root() : experiment.files.experiment.parent_path();
  if (!ask.has("experiment")) return subject;
  subject.robots = experiment.robots;
  if (experiment.files.robot.empty()) return subject;
  Problems problems;
  FolderFiles files(folder_);
  const auto robot = files.open("robot", experiment.files.robot.string(), -1, config::kMaxBytes);
  if (!robot) return tl::unexpected<Error>(robot.error());
  subject.file = read_description(files, *robot, experiment.robot_overrides, problems);
  if (!problems.empty()) return tl::unexpected<Error>(problems.sorted().front());
  return subject;
}

/// The built-in simulation can be tried at once: its files are read and checked.
Reply LinkRoutes::test_simulation(const Wanted& wanted, const Ask& ask) {
  Json findings = Json::array();
  std::optional<Prepared> prepared;
  if (const auto refused = wanted_.prepare_wanted(wanted, ask, prepared)) {
    const Json error = parsed(refused->body)["error"];
    if (refused->status != 400) return *refused;
    for (const Json& problem : error["arguments"].value("problems", Json::array())) {
      findings.push_back({{"good", false}, {"message", problem["message"]}});
    }
  } else {
    const Sentence ready = say({"the simulation is ready: {} robot{} of \"{}\", a tick each {} s",
                                "la simulación está lista: {} robot{} de \"{}\", un ciclo cada {} s"},
                               prepared->experiment.robots, prepared->experiment.robots == 1 ? "" : "s",
                               prepared->application->description().name, prepared->step_s);
    findings.push_back({{"good", true}, {"message", ready.in(ask.language)}});
  }
  tested_ = {
      {"test", std::to_string(++tests_)}, {"done", true}, {"good", prepared.has_value()}, {"findings", findings}};
  return json_reply({{"test", tested_}});
}

Reply LinkRoutes::test(const Ask& ask) {
  if (test_ && !test_->over()) {
    return ask.refuse(
        "Running",
        say({"a connection is being tested; wait for its end", "ya se prueba una conexión; espere a que termine"}),
        409);
  }
  test_.reset();
  Wanted wanted;
  Experiment experiment;
  if (ask.has("experiment")) {
    if (auto refused = wanted_.read_wanted(ask, wanted)) return *refused;
    if (auto refused = wanted_.read_experiment_of(wanted, ask, experiment)) return *refused;
    if (!experiment.link.remote()) return test_simulation(wanted, ask);
  } else {
    if (auto refused = wanted_.read_application(ask, wanted)) return *refused;
    if (ask.text("address").empty() && !ask.has("program")) {
      return ask.refuse("BadRequest",
                        say({"an experiment, an address or a program is needed",
                             "hace falta un experimento, una dirección o un programa"}),
                        400);
    }
    experiment.link = wanted.link;
  }
  auto subject = subject_of(experiment, ask);
  if (!subject) return failure(subject.error(), ask.language);
  const auto told = [on_hub = on_hub_](const Json& state) { on_hub([state](Hub& hub) { hub.event("link", state); }); };
  test_ = std::make_unique<LinkCheck>(std::to_string(++tests_), std::move(*subject), ask.language, told);
  return json_reply({{"test", test_->state()}});
}

}  // namespace ganglion::studio
