#pragma once

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
  Result<void> write() const { return write_file(path_, text_); }
  void remove() const noexcept {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }

 private:
  std::filesystem::path path_;
  std::string text_;
};

}  // namespace ganglion::studio
