#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ganglion {

/// The program as another process, its output in files of `folder`. Killed with the object if it is still there.
class Child {
 public:
  struct Limits {
    std::uint64_t file_bytes = 0;    ///< Largest file it may write; 0 = any.
    std::uint64_t memory_bytes = 0;  ///< Address space it may take; 0 = any.
    const char* output = nullptr;    ///< Where standard output goes instead.
  };
  Child(const std::filesystem::path& folder, std::vector<std::string> words);
  Child(const std::filesystem::path& folder, std::vector<std::string> words, const Limits& limits);
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();

  void send(int signal) const;
  /// Waits until the file, or what is there of it, has at least so many bytes. False if the program ended before.
  bool wait_for(const std::filesystem::path& file, std::uint64_t bytes);
  /// Waits for its end: the exit code, or minus the signal that ended it.
  int wait();
  pid_t process() const noexcept { return pid_; }
  std::string out() const;
  std::string err() const;

 private:
  bool running();
  std::filesystem::path folder_;
  pid_t pid_ = -1;
  int status_ = 0;
};

/// The file, or while it is being written the one of a name of its own that is to become it.
std::filesystem::path being_written(const std::filesystem::path& file);

}  // namespace ganglion
