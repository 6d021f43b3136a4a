#include "ganglion/record/mcap/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>

#include "ganglion/record/mcap/fields.h"

namespace ganglion::mcap {

struct OutputFile::Handle {
  Handle(std::string file_name, int descriptor) : name(std::move(file_name)), fd(descriptor) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    stop_syncing();
    if (fd >= 0) ::close(fd);
  }

  void keep(int number) noexcept {
    int none = 0;
    first_errno.compare_exchange_strong(none, number);
  }

  void sync() noexcept {
    // EINVAL: a pipe or a device, which has no disk to wait for.
    if (::fdatasync(fd) != 0 && errno != EINVAL) keep(errno);
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
  int fd;
  std::atomic<int> first_errno = 0;
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

Result<OutputFile> OutputFile::create(const std::filesystem::path& path) {
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (fd < 0) {
    return fail_at({path.string()}, ErrorCode::Unwritable, {"cannot be written: {}", "no se puede escribir: {}"},
                   std::generic_category().message(errno));
  }
  return OutputFile(std::make_unique<Handle>(path.string(), fd));
}

void OutputFile::write(std::string_view bytes) {
  crc_ = crc32(bytes, crc_);
  position_ += bytes.size();
  while (!bytes.empty() && !failed()) {
    const ssize_t count = ::write(handle_->fd, bytes.data(), bytes.size());
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
  if (handle_->fd >= 0) {
    if (durable) handle_->sync();
    if (::close(handle_->fd) != 0) handle_->keep(errno);
    handle_->fd = -1;
  }
  return status();
}

bool OutputFile::is_open() const noexcept { return handle_ != nullptr && handle_->fd >= 0; }

bool OutputFile::failed() const noexcept { return handle_->first_errno != 0; }

Result<void> OutputFile::status() const {
  if (!failed()) return {};
  return fail_at({handle_->name}, ErrorCode::Unwritable, {"cannot be written: {}", "no se puede escribir: {}"},
                 std::generic_category().message(handle_->first_errno));
}

}  // namespace ganglion::mcap
