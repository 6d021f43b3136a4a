#pragma once

#include "ganglion/plot/view/language.h"

namespace ganglion::plot {

/// Every word in a picture, in the terms of the papers.
struct Words {
  Word trajectory;
  Word trajectory_about;
  Word signals;
  Word signals_about;
  Word behaviours;
  Word behaviours_about;
  Word legend;
  Word start;
  Word end;
  Word path;
  Word contact;
  Word wall;
  Word static_obstacle;
  Word dynamic_obstacle;
  Word earlier_place;
  Word unknown_ground;
  Word floor_zone;
  Word bump;
  Word beacon;
  Word true_outline;
  Word no_behaviour;
  Word active;
  Word suppressed;
  Word quiet;
  Word time;
  Word unexplored;
  Word no_reading;
  Word nothing_in_range;
  Word too_close;
  Word no_data;
  Word robot;
};

const Words& words(Language language) noexcept;

using WordOf = Word Words::*;

}  // namespace ganglion::plot
