#include "ganglion/experience/writer.h"

#include <array>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "ganglion/experience/handover.h"

namespace ganglion {

struct ExperienceWriter::Shared {
  explicit Shared(ExperienceStore opened) : store(std::move(opened)) {
    for (Handover& one : pool) free.push_back(&one);
    thread = std::thread([this] { work(); });
  }

  void work() {
    std::unique_lock lock(mutex);
    while (true) {
      asked.wait(lock, [&] { return served < wanted || stopping; });
      if (served == wanted) return;
      const std::uint64_t serving = wanted;
      while (!waiting.empty() && commit_first(lock)) {
      }
      served = serving;
      done.notify_all();
    }
  }

  /// False where it failed: then it stays the first.
  bool commit_first(std::unique_lock<std::mutex>& lock) {
    const Handover& first = *waiting.front();
    lock.unlock();
    auto outcome = store.commit(first.encoded());
    Result<void> moved;
    if (outcome && outcome->stale) moved = move_beside();
    lock.lock();
    if (!outcome || !moved) {
      failure = outcome ? moved.error() : outcome.error();
      return false;
    }
    failure.reset();
    const bool stale = outcome->stale;
    if (stale) beside = store.file();
    anew = anew || stale;  // the new store needs all parts, and those under way are not all
    do {
      free.push_back(waiting.front());
      waiting.pop_front();
    } while (stale && !waiting.empty());
    return true;
  }

  Result<void> move_beside() {
    auto other = store.open_beside();
    if (!other) return tl::unexpected<Error>(other.error());
    store = std::move(*other);
    return {};
  }

  Result<void> status() const {
    if (failure) return tl::unexpected(*failure);
    return {};
  }

  ExperienceStore store;  ///< Used by the thread only.
  HandedParts handed;     ///< Used by the run only.
  std::array<Handover, kHandovers> pool;

  mutable std::mutex mutex;  ///< Guards what follows; never held while something is copied or written.
  std::condition_variable asked;
  std::condition_variable done;
  std::vector<Handover*> free;
  std::deque<Handover*> waiting;
  bool anew = false;         ///< All parts are to be handed over, whether they changed or not.
  std::uint64_t wanted = 0;  ///< Commits asked for.
  std::uint64_t served = 0;  ///< Commits tried, counted by the newest that each one covers.
  std::optional<Error> failure;
  std::optional<std::string> beside;
  bool stopping = false;
  std::thread thread;
};

ExperienceWriter::ExperienceWriter(ExperienceStore store) : shared_(std::make_unique<Shared>(std::move(store))) {}

ExperienceWriter::~ExperienceWriter() {
  {
    const std::lock_guard lock(shared_->mutex);
    shared_->stopping = true;
    if (!shared_->waiting.empty()) ++shared_->wanted;
  }
  shared_->asked.notify_one();
  shared_->thread.join();
}

bool ExperienceWriter::offer(std::span<const LearningComponent> learners) {
  Handover* place = nullptr;
  {
    const std::lock_guard lock(shared_->mutex);
    if (std::exchange(shared_->anew, false)) shared_->handed.clear();
    if (!anything_new(learners, shared_->handed)) return true;
    if (shared_->free.empty()) {
      ++shared_->wanted;  // a failure may have passed
    } else {
      place = shared_->free.back();
      shared_->free.pop_back();
    }
  }
  if (place != nullptr) {
    place->take(learners, shared_->handed);
    const std::lock_guard lock(shared_->mutex);
    if (shared_->anew) {  // meanwhile: what changed is not enough
      shared_->free.push_back(place);
      return false;
    }
    shared_->waiting.push_back(place);
    ++shared_->wanted;
  }
  shared_->asked.notify_one();
  return place != nullptr;
}

Result<void> ExperienceWriter::wait_for_commit() {
  std::unique_lock lock(shared_->mutex);
  const std::uint64_t mine = ++shared_->wanted;
  shared_->asked.notify_one();
  shared_->done.wait(lock, [&] { return shared_->served >= mine; });
  return shared_->status();
}

Result<void> ExperienceWriter::conclude(std::span<const LearningComponent> learners) {
  while (true) {
    const auto freed = wait_for_commit();
    if (!offer(learners)) return freed;  // full of what cannot be committed
    if (auto committed = wait_for_commit(); !committed) return committed;
    const std::lock_guard lock(shared_->mutex);
    if (!shared_->anew) return {};
  }
}

Result<void> ExperienceWriter::status() const {
  const std::lock_guard lock(shared_->mutex);
  return shared_->status();
}

std::optional<std::string> ExperienceWriter::beside() const {
  const std::lock_guard lock(shared_->mutex);
  return shared_->beside;
}

}  // namespace ganglion
