#include "ganglion/studio/folder/folder_files.h"

namespace ganglion::studio {

Result<std::string> FolderFiles::read(const std::filesystem::path& resolved, std::size_t most_bytes) {
  if (!folder_.holds(resolved)) {
    if (outside_.empty()) outside_ = resolved;
    return fail_at({resolved.string()}, ErrorCode::BadParameter,
                   {"lies outside of the folder that the studio was started for",
                    "está fuera de la carpeta para la que se inició el estudio"});
  }
  auto text = folder_.bytes_of(resolved, most_bytes);
  if (!text && text.error().place.file.empty()) text.error().place = {resolved.string()};
  return text;
}

}  // namespace ganglion::studio
