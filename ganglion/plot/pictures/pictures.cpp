#include "ganglion/plot/pictures/pictures.h"

#include <algorithm>

#include "ganglion/plot/pictures/lists.h"

namespace ganglion::plot {

std::vector<const PictureKind*> picture_kinds() {
  std::vector<const PictureKind*> kinds(k_plot_picture.begin(), k_plot_picture.end());
  std::ranges::stable_sort(kinds, {}, &PictureKind::order);
  return kinds;
}

std::vector<Picture> all_pictures(const RunView& run, Language language, std::span<const std::string> only) {
  std::vector<Picture> pictures;
  for (const PictureKind* kind : picture_kinds()) {
    const bool asked = only.empty() || std::ranges::find(only, kind->descriptor.name) != only.end();
    if (!asked || !kind->wants(run)) continue;
    for (Picture& picture : kind->draw(run, language)) pictures.push_back(std::move(picture));
  }
  return pictures;
}

}  // namespace ganglion::plot
