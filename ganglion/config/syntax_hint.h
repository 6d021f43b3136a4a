#pragma once

#include <string_view>

#include "ganglion/base/sentence.h"

namespace ganglion::config {

/// What the TOML parser complains about, in the words of someone who writes a robot's file for the first time:
/// "Error while parsing value: could not determine value type" becomes `this is no value; texts stand in quotes`.
/// What is not known here comes back as the parser says it.
Sentence syntax_hint(std::string_view description);

}  // namespace ganglion::config
