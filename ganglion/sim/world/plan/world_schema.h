#pragma once

#include <list>
#include <string>

#include "ganglion/config/outline.h"

namespace ganglion::sim {

/// What the reader of world.toml asks, form by form.
std::list<config::Outline> world_outlines();

/// JSON Schema (2020-12) of world.toml, for editors that complete and check while one types. It knows keys, types,
/// ranges and choices; whether outlines cross or a spawn lies in a wall is for load_plan() and Ground.
std::string world_schema();

}  // namespace ganglion::sim
