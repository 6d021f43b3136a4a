#pragma once

#include <list>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "ganglion/config/outline.h"

namespace ganglion::config {

/// JSON Schema (2020-12) of a type of file, made from what its reader asked of samples: `title`, and every key with
/// type, limits, choices and default. What the samples say differently of a key is left open. A key is required where
/// each sample required it; where tables come in forms (a mover has a path or places), `anyOf` says what each form
/// requires and what it bars. Tables of kinds are one of their kinds each.
std::string schema_text(std::string_view title, const std::list<Outline>& samples);

/// The same of a table, without heading.
nlohmann::ordered_json table_schema(const std::list<Outline>& samples);

}  // namespace ganglion::config
