#include "ganglion/studio/folder/beneath.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace ganglion::studio {
namespace {

namespace fs = std::filesystem;

constexpr int kFolderFlags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const noexcept { return number_; }
  bool open() const noexcept { return number_ >= 0; }

 private:
  int number_;
};

std::string reason(int code) { return std::error_code(code, std::generic_category()).message(); }

/// What an open() that failed means to somebody who wants a file of this folder.
tl::unexpected<Error> refused(ErrorCode otherwise, int code) {
  if (code == ENOENT || code == ENOTDIR || code == ELOOP || code == ENAMETOOLONG) {
    return fail(ErrorCode::NotFound, {"there is no such file", "no existe el archivo"});
  }
  return otherwise == ErrorCode::Unwritable
             ? fail(otherwise, {"cannot be written: {}", "no se puede escribir: {}"}, reason(code))
             : fail(otherwise, {"cannot be read: {}", "no se puede leer: {}"}, reason(code));
}

/// The folder that holds the file, each part opened from the one before; not open where that failed, with errno.
Descriptor folder_of(const fs::path& root, const fs::path& inner, bool make) {
  Descriptor folder(::open(root.c_str(), kFolderFlags));
  for (const fs::path& part : inner.parent_path()) {
    if (!folder.open()) break;
    if (make && ::mkdirat(folder.number(), part.c_str(), 0777) != 0 && errno != EEXIST) return Descriptor(-1);
    folder = Descriptor(::openat(folder.number(), part.c_str(), kFolderFlags));
  }
  return folder;
}

bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t put = ::write(file, text.data(), text.size());
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(put));
  }
  return true;
}

}  // namespace

Result<std::string> read_beneath(const fs::path& root, const fs::path& inner, std::size_t max_bytes) {
  const Descriptor folder = folder_of(root, inner, false);
  if (!folder.open()) return refused(ErrorCode::Unreadable, errno);
  constexpr int kFlags = O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
  const Descriptor file(::openat(folder.number(), inner.filename().c_str(), kFlags));
  if (!file.open() && errno == ENXIO)
    return fail(ErrorCode::Unreadable, {"is not a regular file", "no es un archivo corriente"});  // a socket
  if (!file.open()) return refused(ErrorCode::Unreadable, errno);
  struct stat about {};
  if (::fstat(file.number(), &about) != 0) return refused(ErrorCode::Unreadable, errno);
  if (!S_ISREG(about.st_mode))
    return fail(ErrorCode::Unreadable, {"is not a regular file", "no es un archivo corriente"});
  const auto size = static_cast<std::size_t>(about.st_size);
  if (size > max_bytes)
    return fail(ErrorCode::TooLarge, {"has {} bytes; the limit here is {}", "tiene {} bytes; aquí el límite es {}"},
                size, max_bytes);
  std::string text(size, '\0');
  std::size_t read = 0;
  while (read < size) {
    const ssize_t got = ::read(file.number(), text.data() + read, size - read);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return refused(ErrorCode::Unreadable, errno);
    if (got == 0) break;
    read += static_cast<std::size_t>(got);
  }
  text.resize(read);
  return text;
}

Result<void> write_beneath(const fs::path& root, const fs::path& inner, std::string_view text) {
  const Descriptor folder = folder_of(root, inner, true);
  if (!folder.open()) return refused(ErrorCode::Unwritable, errno);
  const std::string name = inner.filename().string();
  const std::string part = name + "." + std::to_string(::getpid()) + ".part";
  ::unlinkat(folder.number(), part.c_str(), 0);  // left by one that was killed, or put there to be followed
  constexpr int kFlags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  const Descriptor file(::openat(folder.number(), part.c_str(), kFlags, 0666));
  if (!file.open()) return refused(ErrorCode::Unwritable, errno);
  if (write_all(file.number(), text) && ::renameat(folder.number(), part.c_str(), folder.number(), name.c_str()) == 0) {
    return {};
  }
  const int code = errno;
  ::unlinkat(folder.number(), part.c_str(), 0);
  return fail(ErrorCode::Unwritable, {"cannot be written: {}", "no se puede escribir: {}"}, reason(code));
}

void remove_beneath(const fs::path& root, const fs::path& inner) {
  const Descriptor folder = folder_of(root, inner, false);
  if (folder.open()) ::unlinkat(folder.number(), inner.filename().c_str(), 0);
}

}  // namespace ganglion::studio
