#pragma once

#include <string>

#include "ganglion/base/files.h"
#include "ganglion/studio/folder/folder.h"

namespace ganglion::studio {

/// Opens files below a folder, and no others, whatever names them and whatever links are put in the way.
class FolderFiles final : public FileReader {
 public:
  /// It must outlive this.
  explicit FolderFiles(const Folder& folder) : folder_(folder) {}

  /// The first file outside that was asked for; "" = none was. None was opened.
  const std::filesystem::path& outside() const noexcept { return outside_; }

 private:
  Result<std::string> read(const std::filesystem::path& resolved, std::size_t most_bytes) override;

  const Folder& folder_;
  std::filesystem::path outside_;
};

}  // namespace ganglion::studio
