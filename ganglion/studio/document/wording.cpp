#include "ganglion/studio/document/wording.h"

namespace ganglion::studio {

std::string worded(std::string_view message, Language) { return std::string(message); }

}  // namespace ganglion::studio
