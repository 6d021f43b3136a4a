#include "ganglion/plot/picture/pictures.h"

namespace ganglion::plot {

std::vector<Picture> all_pictures(const RunView& run, Language language) {
  std::vector<Picture> pictures{trajectory_picture(run, language)};
  for (const auto make : {learned_map_pictures, behaviour_pictures, signal_pictures})
    for (Picture& picture : make(run, language)) pictures.push_back(std::move(picture));
  return pictures;
}

}  // namespace ganglion::plot
