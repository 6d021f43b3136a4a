#pragma once

#include <nlohmann/json.hpp>

#include "ganglion/record/exhibit/track.h"

namespace ganglion {

// What was shown as JSON for pages: sentences as {"en", "es"}, roles by name, points as [x, y, x, y...], numbers that are
// not finite as null.

/// Everything of an exhibit but the cells of a field; a patch has nothing to say.
nlohmann::json json_of(const shown::Exhibit& exhibit);
nlohmann::json json_of(const shown::Shape& shape);
/// How each role is drawn and called, by its name: {"en", "es", "light": "#rrggbb", "dark", "dash": [on, off], "sign",
/// "filled", "over"}.
nlohmann::json roles_json();

}  // namespace ganglion
