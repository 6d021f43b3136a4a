#include "ganglion/record/mcap/output_file.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include "ganglion/base/new_file.h"
#include "ganglion/record/mcap/fields.h"

namespace ganglion::mcap {

struct OutputFile::Handle {
  Handle(std::string file_name, NewFile made, Placing place)
      : name(std::move(file_name)), file(std::move(made)), placing(place) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { stop_syncing(); }

  void keep(int number) noexcept {
    int none = 0;
    first_errno.compare_exchange_strong(none, number);
  }

  void sync() noexcept {
    // EINVAL: a pipe or a device, which has no disk to wait for.
    if (::fdatasync(file.descriptor()) != 0 && errno != EINVAL) keep(errno);
  }

  void sync_when_asked() {
    std::unique_lock lock(mutex);
    while (true) {
      asked.wait(lock, [&] { return wanted || stopping; });
      if (stopping) return;
      wanted = false;
      lock.unlock();
      sync();
      lock.lock();
    }
  }

  void stop_syncing() {
    if (!syncer.joinable()) return;
    {
      const std::lock_guard lock(mutex);
      stopping = true;
    }
    asked.notify_one();
    syncer.join();
  }

  std::string name;
  NewFile file;
  Placing placing;
  bool open = true;
  std::atomic<int> first_errno = 0;
  std::optional<Error> refusal;  ///< Of its place.
  std::mutex mutex;
  std::condition_variable asked;
  bool wanted = false;
  bool stopping = false;
  std::thread syncer;
};

OutputFile::OutputFile(std::unique_ptr<Handle> handle) noexcept : handle_(std::move(handle)) {}
OutputFile::OutputFile(OutputFile&&) noexcept = default;
OutputFile& OutputFile::operator=(OutputFile&&) noexcept = default;
OutputFile::~OutputFile() = default;

Result<OutputFile> OutputFile::create(const std::filesystem::path& path, Placing placing) {
  const bool replaces = placing == Placing::Replace;
  auto file = NewFile::beside(path, replaces ? "" : path.extension().string());
  if (!file) return tl::unexpected<Error>(file.error());
  if (!replaces) file->keep();
  const std::string name = (replaces ? path : file->path()).string();
  return OutputFile(std::make_unique<Handle>(name, std::move(*file), placing));
}

void OutputFile::write(std::string_view bytes) {
  crc_ = crc32(bytes, crc_);
  position_ += bytes.size();
  while (!bytes.empty() && !failed()) {
    const ssize_t count = ::write(handle_->file.descriptor(), bytes.data(), bytes.size());
    if (count > 0)
      bytes.remove_prefix(static_cast<std::size_t>(count));
    else if (count < 0 && errno != EINTR)
      handle_->keep(errno);
  }
}

void OutputFile::start_sync() {
  if (!handle_->syncer.joinable())
    handle_->syncer = std::thread([handle = handle_.get()] { handle->sync_when_asked(); });
  {
    const std::lock_guard lock(handle_->mutex);
    handle_->wanted = true;
  }
  handle_->asked.notify_one();
}

Result<void> OutputFile::close(bool durable) {
  handle_->stop_syncing();
  if (!std::exchange(handle_->open, false)) return status();
  if (durable) handle_->sync();
  if (!failed() && handle_->placing == Placing::Replace) {
    if (auto placed = handle_->file.replace(durable); !placed) handle_->refusal = placed.error();
  }
  if (!handle_->file.close()) handle_->keep(errno);
  return status();
}

std::filesystem::path OutputFile::path() const { return handle_->file.path(); }

bool OutputFile::is_open() const noexcept { return handle_ != nullptr && handle_->open; }

bool OutputFile::failed() const noexcept { return handle_->first_errno != 0; }

Result<void> OutputFile::status() const {
  if (handle_->refusal) return tl::unexpected<Error>(*handle_->refusal);
  if (!failed()) return {};
  return fail_at({handle_->name}, ErrorCode::Unwritable, {"cannot be written: {}", "no se puede escribir: {}"},
                 std::generic_category().message(handle_->first_errno));
}

}  // namespace ganglion::mcap
