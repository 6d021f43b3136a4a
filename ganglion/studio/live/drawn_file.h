#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>

#include "ganglion/base/file.h"

namespace ganglion::studio {

/// A drawing that runs without being saved: a hidden file beside its own, so that the paths in it are right. It is
/// there only while somebody reads it.
class DrawnFile {
 public:
  DrawnFile(const std::filesystem::path& controller, std::string text)
      : path_(controller.parent_path() / ("." + controller.filename().string() + ".running")), text_(std::move(text)) {}
  ~DrawnFile() { remove(); }
  DrawnFile(const DrawnFile&) = delete;
  DrawnFile& operator=(const DrawnFile&) = delete;

  const std::filesystem::path& path() const noexcept { return path_; }
  Result<void> write() const {
    there_ = true;
    return write_file(path_, text_);
  }
  /// Once for each write(): by then the place may be another's.
  void remove() const noexcept {
    std::error_code ignored;
    if (there_.exchange(false)) std::filesystem::remove(path_, ignored);
  }

 private:
  std::filesystem::path path_;
  std::string text_;
  mutable std::atomic<bool> there_ = false;
};

}  // namespace ganglion::studio
