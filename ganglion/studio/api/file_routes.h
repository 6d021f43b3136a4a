#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "ganglion/studio/api/hooks.h"
#include "ganglion/studio/api/router.h"
#include "ganglion/studio/folder/listing.h"

namespace ganglion::studio {

/// The commands about files as texts: what there is, opening, saving, drafts.
class FileRoutes {
 public:
  /// Folder, listing and this object must outlive the router's last call.
  FileRoutes(Router& router, const Folder& folder, Listing& listing, OnHub on_hub);

  /// Tells of opened files that changed on the disk.
  void look_for_changes();

 private:
  Reply open(const Ask&);
  Reply save(const Ask&);
  Reply autosave(const Ask&) const;
  Reply discard(const Ask&) const;
  void note_opened(const std::string& name, const std::string& hash);

  const Folder& folder_;
  Listing& listing_;
  const OnHub on_hub_;
  std::map<std::string, std::string> opened_;  ///< Hash last told, by name.
  std::map<std::string, std::filesystem::file_time_type> changed_;
};

}  // namespace ganglion::studio
