#pragma once

#include <string>

#include "ganglion/plot/view/run_view.h"
#include "ganglion/report/words.h"

namespace ganglion::report {

/// What there is in a run to be shown or switched off.
struct Content {
  bool way = false;
  bool sensors = false;
  bool movers = false;
  bool behaviours = false;
  bool walls = false;
  bool furniture = false;
  bool zones = false;
  bool bumps = false;
  bool beacons = false;
};
Content content_of(const plot::RunView& run);

/// The player's signs explained, those only that the run shows.
std::string legend_html(const plot::RunView& run, plot::Language language);

}  // namespace ganglion::report
