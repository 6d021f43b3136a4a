#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "ganglion/record/run_file.h"
#include "ganglion/studio/api/router.h"
#include "ganglion/studio/folder/listing.h"
#include "ganglion/studio/live/recording_view.h"

namespace ganglion::studio {

/// The commands about runs that were recorded.
class RecordingRoutes {
 public:
  /// Folder, listing and this object must outlive the router's last call.
  RecordingRoutes(Router& router, const Folder& folder, Listing& listing);

 private:
  Reply open(const Ask&);
  Reply samples(const Ask&);
  Reply report(const Ask&) const;
  Reply controller(const Ask&);
  Result<RunFile> recording_of(const std::string& name) const;
  Result<std::shared_ptr<const RecordingView>> view_of(const std::string& name);

  const Folder& folder_;
  Listing& listing_;
  std::string viewed_;
  std::filesystem::file_time_type viewed_changed_{};
  std::shared_ptr<const RecordingView> view_;
};

}  // namespace ganglion::studio
