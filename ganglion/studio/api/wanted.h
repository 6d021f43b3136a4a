#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ganglion/link/net/address.h"
#include "ganglion/run/experiment.h"
#include "ganglion/run/prepared.h"
#include "ganglion/studio/api/ask.h"
#include "ganglion/studio/api/programs.h"
#include "ganglion/studio/folder/folder_files.h"

namespace ganglion::studio {

/// What the page wants to run or to test, in files and keys.
struct Wanted {
  std::filesystem::path experiment;
  ExperimentFiles instead;
  std::vector<config::Override> overrides;
  LinkChoice link;                   ///< Where the page says that the robot is.
  std::optional<std::string> drawn;  ///< The controller's text where it runs without being saved.
};

/// Where the studio may look for a robot: tcp://HOST:PORT, serial+tcp://HOST:PORT, serial:///dev/tty... Fails with
/// BadParameter.
Result<link::Address> allowed_address(const std::string& text);

/// Reads what the page wants, and sees to it that nothing outside of the folder is read and no program started but
/// those the user allows. Where something must not be, or cannot be read, that is the reply.
class WantedReader {
 public:
  /// Both must outlive it.
  WantedReader(const Folder& folder, const std::vector<AllowedProgram>& programs)
      : folder_(folder), programs_(programs) {}

  /// All the page says: files, keys, where the robot is.
  std::optional<Reply> read_wanted(const Ask&, Wanted& wanted) const;
  /// Only where the robot is: an address, "" for the simulation, or a listed program.
  std::optional<Reply> read_application(const Ask&, Wanted& wanted) const;
  /// The experiment that is meant; what is wrong in its files is for prepare_wanted().
  std::optional<Reply> read_experiment_of(const Wanted& wanted, const Ask&, Experiment& experiment) const;
  /// Everything the run needs.
  std::optional<Reply> prepare_wanted(const Wanted& wanted, const Ask&, std::optional<Prepared>& prepared) const;

 private:
  Result<void> read_files(const Ask&, Wanted& wanted) const;
  std::optional<Reply> read_sets(const Ask&, Wanted& wanted) const;
  std::optional<Reply> refuse_experiment(const Experiment& experiment, const FolderFiles& files, const Ask&) const;
  std::optional<Reply> read_through(FolderFiles& files, const Wanted& wanted, const Ask&, Experiment& experiment) const;

  const Folder& folder_;
  const std::vector<AllowedProgram>& programs_;
};

}  // namespace ganglion::studio
