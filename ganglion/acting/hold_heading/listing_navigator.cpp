#include "ganglion/acting/hold_heading/listing_navigator.h"

#include <cmath>

#include "ganglion/acting/subsumption/subsumption.h"

namespace ganglion {

Command ListingNavigator::navigate(float heading_deg, bool displaced, std::optional<float> course_deg) noexcept {
  if (!std::isnan(heading_deg)) heading_ = heading_deg;
  if (!started_) rumbo_ = sp_rumbo_ = heading_;
  started_ = true;
  if (course_deg) {
    sp_rumbo_ = *course_deg;
    if (!rumbo_is_held_) rumbo_ = sp_rumbo_;
  }
  if (displaced) {  // the end of EVITAR and ESCAPE, and of the program cycle they ran in
    rumbo_ = heading_;
    rumbo_is_held_ = true;
    contador_ = 0;
    count_cycle();
  }
  target_ = rumbo_;
  held_ = rumbo_is_held_;
  const Command command = subsumption::listing_pulses(subsumption::listing_m(rumbo_, heading_), 10.0F);
  count_cycle();
  return command;
}

/// The last lines of the main loop.
void ListingNavigator::count_cycle() noexcept {
  if (contador_ >= 15) {
    rumbo_ = sp_rumbo_;
    rumbo_is_held_ = false;
    contador_ = 0;
  }
  ++contador_;
}

}  // namespace ganglion
