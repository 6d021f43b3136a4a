#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "ganglion/base/file_handle.h"
#include "ganglion/base/result.h"

namespace ganglion {

/// A file in the making: whole in its place, or not there at all. It is made under a name of its own, which nobody can
/// foresee, in the folder that it shall lie in; that folder is held by its descriptor from then on. No link is followed
/// that stands, or is put, where the file or its own name shall be. It is removed again unless it came to its place or
/// is kept.
class NewFile {
 public:
  /// Beside `path`, named "STEM.part-PROCESS-NUMBER" and `ending`; without one it is to replace `path`. Missing folders
  /// are made. Fails with Unwritable, without an ending as replace() does.
  static Result<NewFile> beside(const std::filesystem::path& path, std::string_view ending = "");
  /// The same beneath a folder, where no link is followed on the way down. `inner` is relative to `root`, without "."
  /// and ".."; the root is not made. Fails with NotFound or Unwritable.
  static Result<NewFile> beneath(const std::filesystem::path& root, const std::filesystem::path& inner);
  NewFile(NewFile&& other) noexcept;
  NewFile& operator=(NewFile&&) = delete;
  ~NewFile();

  /// To write to.
  int descriptor() const noexcept { return file_.number(); }
  /// Where it lies now.
  std::filesystem::path path() const { return folder_path_ / name_; }
  /// It stays, whole or not, under the name that it has.
  void keep() noexcept { temporary_ = false; }

  /// Fails with Unwritable (disk full...).
  Result<void> write(std::string_view content);
  /// Waits for the disk (if `durable`) and takes the place of the file it was made for, whose mode and owner it gets.
  /// Fails with Unwritable, also where that file is write-protected, or what is there is a link, a folder or a device.
  Result<void> replace(bool durable = true);
  /// False where the system has only now found out that something could not be written; says why in errno.
  bool close() noexcept { return file_.close(); }

 private:
  NewFile(FileHandle folder, std::filesystem::path path);
  static Result<NewFile> in(FileHandle folder, const std::filesystem::path& path, std::string_view ending);
  struct Old {
    bool there = false;
    unsigned mode = 0, user = 0, group = 0;
  };
  Result<Old> old_file() const;
  Result<void> take_over() const;

  FileHandle folder_, file_;
  std::filesystem::path folder_path_, target_;
  std::string name_;        ///< Its own, in the folder.
  bool temporary_ = false;  ///< Removed with this object.
};

/// Gives a file another name in its folder, if nothing has that name yet; waits until the folder is on the disk. False
/// where something has it. Fails with Unwritable.
Result<bool> rename_to_free(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace ganglion
