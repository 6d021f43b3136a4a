#include "ganglion/experience/writer.h"

#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace ganglion {

struct ExperienceWriter::Shared {
  explicit Shared(ExperienceStore opened) : store(std::move(opened)), thread([this] { work(); }) {}

  void work() {
    std::unique_lock lock(mutex);
    while (true) {
      asked.wait(lock, [&] { return served < wanted || stopping; });
      if (served == wanted) return;
      const std::uint64_t serving = wanted;
      std::vector<StoredPart> batch = take_pending();
      lock.unlock();
      const auto outcome = store.commit(batch);
      lock.lock();
      failure = outcome ? std::nullopt : std::optional(outcome.error());
      if (failure) keep_for_later(std::move(batch));
      served = serving;
      done.notify_all();
    }
  }

  std::vector<StoredPart> take_pending() {
    std::vector<StoredPart> batch;
    batch.reserve(pending.size());
    for (auto& [key, part] : pending) batch.push_back(std::move(part));
    pending.clear();
    return batch;
  }

  void keep_for_later(std::vector<StoredPart> batch) {
    for (StoredPart& part : batch) {
      auto key = std::pair(part.component, part.name);
      pending.try_emplace(std::move(key), std::move(part));  // something newer may have come meanwhile
    }
  }

  Result<void> status() const {
    if (failure) return tl::unexpected(*failure);
    return {};
  }

  ExperienceStore store;  ///< Used by the thread only.
  mutable std::mutex mutex;
  std::condition_variable asked;
  std::condition_variable done;
  std::map<std::pair<std::string, std::string>, StoredPart> pending;
  std::uint64_t wanted = 0;  ///< Commits asked for.
  std::uint64_t served = 0;  ///< Commits tried, counted by the newest that each one covers.
  std::optional<Error> failure;
  bool stopping = false;
  std::thread thread;  ///< Last: it uses all the others.
};

ExperienceWriter::ExperienceWriter(ExperienceStore store) : shared_(std::make_unique<Shared>(std::move(store))) {}

ExperienceWriter::~ExperienceWriter() {
  {
    const std::lock_guard lock(shared_->mutex);
    shared_->stopping = true;
    if (!shared_->pending.empty()) ++shared_->wanted;
  }
  shared_->asked.notify_one();
  shared_->thread.join();
}

void ExperienceWriter::submit(std::vector<StoredPart> parts) {
  {
    const std::lock_guard lock(shared_->mutex);
    for (StoredPart& part : parts) {
      auto key = std::pair(part.component, part.name);
      shared_->pending.insert_or_assign(std::move(key), std::move(part));
    }
    ++shared_->wanted;
  }
  shared_->asked.notify_one();
}

Result<void> ExperienceWriter::flush() {
  std::unique_lock lock(shared_->mutex);
  const std::uint64_t mine = ++shared_->wanted;
  shared_->asked.notify_one();
  shared_->done.wait(lock, [&] { return shared_->served >= mine; });
  return shared_->status();
}

Result<void> ExperienceWriter::status() const {
  const std::lock_guard lock(shared_->mutex);
  return shared_->status();
}

}  // namespace ganglion
