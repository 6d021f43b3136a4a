#pragma once

#include <unistd.h>

#include <utility>

namespace ganglion {

/// A file or folder that is open, closed with its owner.
class FileHandle {
 public:
  explicit FileHandle(int number = -1) noexcept : number_(number) {}
  FileHandle(FileHandle&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileHandle& operator=(FileHandle&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~FileHandle() { close(); }

  int number() const noexcept { return number_; }
  bool open() const noexcept { return number_ >= 0; }
  /// False where the system has only now found out that something could not be written; says why in errno.
  bool close() noexcept { return number_ < 0 || ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

}  // namespace ganglion
