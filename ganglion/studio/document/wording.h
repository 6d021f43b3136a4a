#pragma once

#include <string>
#include <string_view>

#include "ganglion/base/result.h"
#include "ganglion/descriptor/language.h"

namespace ganglion::studio {

/// The message of a check in a language. Checks word themselves in English; a sentence that is not in our dictionary
/// stays so.
std::string worded(std::string_view message, Language language);

}  // namespace ganglion::studio
