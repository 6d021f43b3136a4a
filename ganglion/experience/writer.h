#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "ganglion/base/result.h"
#include "ganglion/experience/store.h"

namespace ganglion {

/// Keeps what a run learns, on a thread of its own: the run copies what changed, raw, into memory that is used again, and
/// goes on; the thread brings it into its stored form and commits it. At most kHandovers are under way; more are not
/// taken, and what they would have held is in a later one.
///
/// A store that was changed by somebody else meanwhile is not written over: from then on all is kept in one beside it.
/// What could not be committed (disk full) is tried again with the next.
class ExperienceWriter {
 public:
  static constexpr int kHandovers = 2;

  explicit ExperienceWriter(ExperienceStore store);
  ExperienceWriter(const ExperienceWriter&) = delete;
  ExperienceWriter& operator=(const ExperienceWriter&) = delete;
  /// Tries once more to commit what is not yet.
  ~ExperienceWriter();

  /// Copies what changed since it last took something. To be called between ticks, with the same components every time;
  /// does not wait. False where nothing could be taken: to be asked again later.
  bool offer(std::span<const LearningComponent> learners);
  /// Takes all that is there and waits until it is committed. Fails with the reason when it cannot be.
  Result<void> conclude(std::span<const LearningComponent> learners);
  /// How the newest commit ended.
  Result<void> status() const;
  /// The store beside the given one, where that was not written to any more.
  std::optional<std::string> beside() const;

 private:
  struct Shared;
  Result<void> wait_for_commit();
  std::unique_ptr<Shared> shared_;
};

}  // namespace ganglion
