#pragma once

#include <memory>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/experience/store.h"

namespace ganglion {

/// Commits experience on a thread of its own, so that the robot never waits for the disk. Parts submitted while a
/// commit runs are gathered, the newest of each kept; what could not be committed (disk full) is tried again with the
/// next.
class ExperienceWriter {
 public:
  explicit ExperienceWriter(ExperienceStore store);
  ExperienceWriter(const ExperienceWriter&) = delete;
  ExperienceWriter& operator=(const ExperienceWriter&) = delete;
  /// Commits what was submitted.
  ~ExperienceWriter();

  /// Takes copies made between ticks. Returns at once.
  void submit(std::vector<StoredPart> parts);
  /// Waits until all submitted so far is committed. Fails with the reason when it could not be; it is still kept.
  Result<void> flush();
  /// How the newest commit ended.
  Result<void> status() const;

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace ganglion
