#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "ganglion/studio/document/drawing.h"
#include "ganglion/studio/folder/listing.h"
#include "ganglion/studio/live/hub.h"
#include "ganglion/studio/live/recording_view.h"
#include "ganglion/studio/live/run_session.h"
#include "ganglion/studio/server/link_check.h"
#include "ganglion/studio/server/programs.h"
#include "ganglion/studio/server/reply.h"
#include "ganglion/studio/server/wanted.h"

namespace ganglion::studio {

/// The commands of the page (docs/studio_api.md), without sockets. Used by one thread at a time.
class Api {
 public:
  struct Hooks {
    /// Has something done by the thread that owns the hub, soon.
    std::function<void(std::function<void(Hub&)>)> on_hub;
    /// Has something done by the thread that uses this object, soon; may be called by any.
    std::function<void(std::function<void(Api&)>)> later;
  };
  Api(Folder folder, std::vector<AllowedProgram> programs, Hooks hooks);

  Reply handle(const Call& call);
  /// Tells of opened files that changed on the disk. To be called about once a second.
  void look_for_changes();
  /// A run that belongs to the command line: it is watched, and cannot be commanded.
  void attach(Json state) { attached_ = std::move(state); }

 private:
  /// What a route is called with.
  struct Ask {
    const Call& call;
    Json body;
    Language language = Language::English;
    std::string text(const char* key) const;
    bool has(const char* key) const { return body.contains(key) && !body[key].is_null(); }
    double number(const char* key, double preset) const;
    /// A failure, worded in the language of this call.
    Reply refuse(std::string_view code, std::string_view message, unsigned status,
                 const Json& arguments = Json::object()) const;
  };
  using Route = Reply (Api::*)(const Ask&);
  static const std::map<std::string, std::pair<std::string_view, Route>>& routes();

  Reply kinds(const Ask&);
  Reply files(const Ask&);
  Reply programs(const Ask&);
  Reply open_file(const Ask&);
  Reply save_file(const Ask&);
  Reply autosave_file(const Ask&);
  Reply discard_draft(const Ask&);

  Reply open_document(const Ask&);
  Reply edit_document(const Ask&);
  Reply ask_connection(const Ask&);
  Reply list_targets(const Ask&);
  Reply copy_components(const Ask&);
  Result<DocumentPlace> place_of(const Ask&) const;

  Reply run_state(const Ask&);
  Reply start_run(const Ask&);
  Reply pause_run(const Ask&);
  Reply resume_run(const Ask&);
  Reply step_run(const Ask&);
  Reply stop_run(const Ask&);
  Reply reset_run(const Ask&);
  Reply pace_run(const Ask&);
  Reply answer(const Ask&, bool done);
  std::optional<Reply> refuse_command(const Ask&) const;
  void note_opened(const std::string& name, const std::string& hash);
  Reply set_goal(const Ask&);
  Reply put_obstacle(const Ask&);
  Reply intervene(const Ask& ask, sim::Intervention what);
  Result<RunPlan> plan_of(const Ask&, const Prepared& prepared);
  Result<void> read_files(const Ask&, Wanted& wanted) const;
  std::optional<Reply> read_sets(const Ask&, Wanted& wanted) const;
  std::optional<Reply> read_application(const Ask&, Wanted& wanted) const;
  std::optional<Reply> read_wanted(const Ask&, Wanted& wanted) const;
  std::optional<Reply> read_experiment_of(const Wanted& wanted, const Ask&, Experiment& experiment) const;
  std::optional<Reply> refuse_experiment(const Experiment& experiment, const std::vector<std::filesystem::path>& files,
                                         const Ask&) const;
  std::optional<Reply> prepare_wanted(const Wanted& wanted, const Ask&, std::optional<Prepared>& prepared) const;
  void begin(std::shared_ptr<const Prepared> prepared, RunPlan plan);
  void tell_state();
  Json state() const;

  Reply test_link(const Ask&);
  Reply link_test(const Ask&);
  Reply test_simulation(const Wanted& wanted, const Ask&);
  Result<LinkCheck::Subject> subject_of(const Experiment& experiment, const Ask&) const;

  Reply open_recording(const Ask&);
  Reply recording_samples(const Ask&);
  Reply recording_report(const Ask&);
  Reply recording_controller(const Ask&);
  Result<RunFile> recording_of(const std::string& name) const;
  Result<std::shared_ptr<const RecordingView>> view_of(const std::string& name);

  Folder folder_;
  Listing listing_;
  std::vector<AllowedProgram> programs_;
  Hooks hooks_;
  std::map<std::string, std::string> opened_;  ///< Hash last told, by name.
  std::map<std::string, std::filesystem::file_time_type> changed_;
  Json attached_;
  std::unique_ptr<RunSession> session_;
  std::shared_ptr<const Prepared> prepared_;
  std::uint64_t runs_ = 0;
  std::unique_ptr<LinkCheck> test_;
  Json tested_;  ///< What the last test found.
  std::uint64_t tests_ = 0;
  std::string viewed_;
  std::filesystem::file_time_type viewed_changed_{};
  std::shared_ptr<const RecordingView> view_;
};

}  // namespace ganglion::studio
