#pragma once

#include <vector>

#include "ganglion/studio/api/current_run.h"
#include "ganglion/studio/api/file_routes.h"
#include "ganglion/studio/api/hooks.h"
#include "ganglion/studio/api/link_routes.h"
#include "ganglion/studio/api/programs.h"
#include "ganglion/studio/api/recording_routes.h"
#include "ganglion/studio/api/router.h"
#include "ganglion/studio/api/run_routes.h"
#include "ganglion/studio/api/wanted.h"
#include "ganglion/studio/folder/listing.h"

namespace ganglion::studio {

/// The commands of the page (docs/studio_api.md), without sockets: the groups of them, and what these share. Used by
/// one thread at a time.
class Api {
 public:
  struct Hooks {
    OnHub on_hub;
    Later later;  ///< To the thread that uses this object.
  };
  Api(Folder folder, std::vector<AllowedProgram> programs, const Hooks& hooks);
  Api(const Api&) = delete;
  Api& operator=(const Api&) = delete;

  Reply handle(const Call& call) { return router_.handle(call); }
  /// Tells of opened files that changed on the disk. To be called about once a second.
  void look_for_changes() { files_.look_for_changes(); }
  /// A run that belongs to the command line: it is watched, and cannot be commanded.
  void attach(Json state) { run_.attach(std::move(state)); }

 private:
  const Folder folder_;
  const std::vector<AllowedProgram> programs_;
  Listing listing_;
  const WantedReader wanted_;
  CurrentRun run_;
  Router router_;
  FileRoutes files_;
  LinkRoutes link_;
  RunRoutes runs_;
  RecordingRoutes recordings_;
};

}  // namespace ganglion::studio
