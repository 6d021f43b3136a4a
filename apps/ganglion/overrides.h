#pragma once

#include <string>
#include <vector>

#include "ganglion/config/value.h"

namespace ganglion {

/// What was given as --set; a text that is no key=value is reported.
inline std::vector<config::Override> overrides_of(const std::vector<std::string>& texts, Problems& problems) {
  std::vector<config::Override> overrides;
  for (const std::string& text : texts) {
    if (auto override = config::parse_override(text)) {
      overrides.push_back(std::move(*override));
    } else {
      problems.add(override.error());
    }
  }
  return overrides;
}

}  // namespace ganglion
