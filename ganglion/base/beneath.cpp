#include "ganglion/base/beneath.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <system_error>

#include "ganglion/base/file.h"
#include "ganglion/base/new_file.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

constexpr int kFolderFlags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;

tl::unexpected<Error> unreadable(int code) {
  if (code == ENOENT || code == ENOTDIR || code == ELOOP || code == ENAMETOOLONG)
    return fail(ErrorCode::NotFound, {"there is no such file", "no existe el archivo"});
  return fail(ErrorCode::Unreadable, {"cannot be read: {}", "no se puede leer: {}"},
              std::generic_category().message(code));
}

tl::unexpected<Error> not_regular() {
  return fail(ErrorCode::Unreadable, {"is not a regular file", "no es un archivo regular"});
}

}  // namespace

FileHandle folder_beneath(const fs::path& root, const fs::path& inner, bool make) {
  FileHandle folder(::open(root.c_str(), kFolderFlags));
  for (const fs::path& part : inner.parent_path()) {
    if (!folder.open()) break;
    if (make && ::mkdirat(folder.number(), part.c_str(), 0777) != 0 && errno != EEXIST) return FileHandle();
    folder = FileHandle(::openat(folder.number(), part.c_str(), kFolderFlags));
  }
  return folder;
}

Result<std::string> read_opened(const FileHandle& file, std::size_t max_bytes) {
  struct stat about {};
  if (::fstat(file.number(), &about) != 0) return unreadable(errno);
  if (!S_ISREG(about.st_mode)) return not_regular();
  const auto size = static_cast<std::size_t>(about.st_size);
  if (size > max_bytes) {
    auto error = too_large({}, size, max_bytes);
    error.value().place = {};
    return error;
  }
  std::string text(size, '\0');
  std::size_t read = 0;
  while (read < size) {
    const ssize_t got = ::read(file.number(), text.data() + read, size - read);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return unreadable(errno);
    if (got == 0) break;
    read += static_cast<std::size_t>(got);
  }
  text.resize(read);
  return text;
}

Result<std::string> read_beneath(const fs::path& root, const fs::path& inner, std::size_t max_bytes) {
  const FileHandle folder = folder_beneath(root, inner, false);
  if (!folder.open()) return unreadable(errno);
  constexpr int kFlags = O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
  const FileHandle file(::openat(folder.number(), inner.filename().c_str(), kFlags));
  if (!file.open() && errno == ENXIO) return not_regular();  // a socket
  if (!file.open()) return unreadable(errno);
  return read_opened(file, max_bytes);
}

Result<void> write_beneath(const fs::path& root, const fs::path& inner, std::string_view text) {
  auto file = NewFile::beneath(root, inner);
  if (!file) return tl::unexpected<Error>(file.error());
  auto written = file->write(text);
  if (written) written = file->replace();
  if (!written) written.error().place = {};
  return written;
}

void remove_beneath(const fs::path& root, const fs::path& inner) {
  const FileHandle folder = folder_beneath(root, inner, false);
  if (folder.open()) ::unlinkat(folder.number(), inner.filename().c_str(), 0);
}

}  // namespace ganglion
