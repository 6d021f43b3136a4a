#include "ganglion/plot/draw_all.h"

#include "ganglion/plot/pictures/pictures.h"

namespace ganglion::plot {

Result<std::vector<std::filesystem::path>> draw_all(const RunView& run, const std::filesystem::path& folder,
                                                    Language language, std::span<const std::string> only) {
  std::vector<std::filesystem::path> paths;
  for (const Picture& picture : all_pictures(run, language, only)) {
    for (const PictureFormat format : {PictureFormat::Svg, PictureFormat::Png, PictureFormat::Pdf}) {
      auto path = save(picture, format, folder);
      if (!path) return tl::unexpected(path.error());
      paths.push_back(std::move(*path));
    }
  }
  return paths;
}

}  // namespace ganglion::plot
