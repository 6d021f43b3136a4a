#include "ganglion/base/new_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <system_error>

#include "ganglion/base/beneath.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostStem = 180;  // a name has at most 255 bytes, its additions included

std::string reason(int code) { return std::generic_category().message(code); }

tl::unexpected<Error> unwritable(const fs::path& path, int code) {
  return fail_at({path.string()}, ErrorCode::Unwritable, {"cannot be written: {}", "no se puede escribir: {}"},
                 reason(code));
}

std::string own_name(const fs::path& path, std::string_view ending) {
  std::uint32_t number = 0;
  if (::getrandom(&number, sizeof number, GRND_NONBLOCK) != sizeof number)
    number = static_cast<std::uint32_t>(::getpid());
  const std::string stem = ending.empty() ? path.filename().string() : path.stem().string();
  return fmt::format("{}.part-{}-{:08x}{}", stem.substr(0, kMostStem), ::getpid(), number, ending);
}

/// Of a file or folder that is open; a pipe or a device has no disk to wait for.
bool sync(int descriptor) noexcept { return ::fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS; }

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

}  // namespace

NewFile::NewFile(FileHandle folder, fs::path path)
    : folder_(std::move(folder)), folder_path_(path.parent_path()), target_(std::move(path)) {}

NewFile::NewFile(NewFile&& other) noexcept
    : folder_(std::move(other.folder_)),
      file_(std::move(other.file_)),
      folder_path_(std::move(other.folder_path_)),
      target_(std::move(other.target_)),
      name_(std::move(other.name_)),
      temporary_(std::exchange(other.temporary_, false)) {}

NewFile::~NewFile() {
  if (temporary_) ::unlinkat(folder_.number(), name_.c_str(), 0);
}

Result<NewFile> NewFile::in(FileHandle folder, const fs::path& path, std::string_view ending) {
  constexpr int kFlags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  constexpr int kTries = 100;
  NewFile file(std::move(folder), path);
  if (ending.empty()) {  // said now rather than when all is written
    if (const auto old = file.old_file(); !old) return tl::unexpected<Error>(old.error());
  }
  for (int tries = 0; tries < kTries && !file.file_.open(); ++tries) {
    file.name_ = own_name(path, ending);
    file.file_ = FileHandle(::openat(file.folder_.number(), file.name_.c_str(), kFlags, 0666));
    if (!file.file_.open() && errno != EEXIST) break;
  }
  if (!file.file_.open()) return unwritable(path, errno);
  file.temporary_ = true;
  return file;
}

Result<NewFile> NewFile::beside(const fs::path& path, std::string_view ending) {
  if (!path.has_filename()) return unwritable(path, EISDIR);
  std::error_code ignored;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), ignored);
  FileHandle folder(::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder.open()) return unwritable(path, errno);
  return in(std::move(folder), path, ending);
}

Result<NewFile> NewFile::beneath(const fs::path& root, const fs::path& inner) {
  FileHandle folder = folder_beneath(root, inner, true);
  if (folder.open()) return in(std::move(folder), root / inner, "");
  if (errno == ENOENT || errno == ENOTDIR || errno == ELOOP || errno == ENAMETOOLONG)
    return fail(ErrorCode::NotFound, {"there is no such file", "no existe el archivo"});
  auto refused = unwritable(inner, errno);
  refused.value().place = {};
  return refused;
}

Result<void> NewFile::write(std::string_view content) {
  while (!content.empty()) {
    const ssize_t put = ::write(file_.number(), content.data(), content.size());
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return unwritable(target_, put < 0 ? errno : ENOSPC);
    content.remove_prefix(static_cast<std::size_t>(put));
  }
  return {};
}

Result<NewFile::Old> NewFile::old_file() const {
  const std::string target = target_.filename().string();
  struct stat old {};
  if (::fstatat(folder_.number(), target.c_str(), &old, AT_SYMLINK_NOFOLLOW) != 0) {
    if (errno == ENOENT) return Old{};
    return unwritable(target_, errno);
  }
  const auto refuse = [&](Text why) {
    return fail_at({target_.string()}, ErrorCode::Unwritable, {"cannot be written: {}", "no se puede escribir: {}"},
                   why);
  };
  if (S_ISLNK(old.st_mode))
    return refuse({"it is a link; name the file that it leads to", "es un enlace; nombre el archivo al que lleva"});
  if (!S_ISREG(old.st_mode)) return refuse({"it is not a regular file", "no es un archivo regular"});
  const bool writable = (old.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) != 0 &&
                        ::faccessat(folder_.number(), target.c_str(), W_OK, AT_EACCESS) == 0;
  if (!writable) return refuse({"it is write-protected", "está protegido contra escritura"});
  return Old{true, old.st_mode, old.st_uid, old.st_gid};
}

Result<void> NewFile::take_over() const {
  const auto old = old_file();
  if (!old) return tl::unexpected<Error>(old.error());
  if (!old->there) return {};
  struct stat mine {};
  if (::fstat(file_.number(), &mine) != 0) return unwritable(target_, errno);
  const bool same_owner = mine.st_uid == old->user && mine.st_gid == old->group;
  const bool owned = same_owner || ::fchown(file_.number(), old->user, old->group) == 0;
  // Whom the file does not belong to any more gets no rights that were meant for others.
  constexpr mode_t kAll = S_IRWXU | S_IRWXG | S_IRWXO;
  if (::fchmod(file_.number(), old->mode & (owned ? kAll : S_IRWXU)) != 0) return unwritable(target_, errno);
  return {};
}

Result<void> NewFile::replace(bool durable) {
  if (auto taken = take_over(); !taken) return taken;
  if (durable && !sync(file_.number())) return unwritable(target_, errno);
  const std::string target = target_.filename().string();
  if (::renameat(folder_.number(), name_.c_str(), folder_.number(), target.c_str()) != 0)
    return unwritable(target_, errno);
  name_ = target;
  temporary_ = false;
  if ((durable && !sync(folder_.number())) || !file_.close()) return unwritable(target_, errno);
  return {};
}

Result<bool> rename_to_free(const fs::path& from, const fs::path& to) {
  const FileHandle folder(::open(folder_of(to).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder.open()) return unwritable(to, errno);
  int done = ::renameat2(AT_FDCWD, from.c_str(), folder.number(), to.filename().c_str(), RENAME_NOREPLACE);
  if (done != 0 && (errno == EINVAL || errno == ENOSYS)) {  // a file system that does not know it, as NFS
    done = ::linkat(AT_FDCWD, from.c_str(), folder.number(), to.filename().c_str(), 0);
    if (done == 0) ::unlink(from.c_str());
  }
  if (done != 0 && errno == EEXIST) return false;
  if (done != 0 || !sync(folder.number())) return unwritable(to, errno);
  return true;
}

}  // namespace ganglion
