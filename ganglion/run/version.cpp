#include "ganglion/run/version.h"

namespace ganglion {

constinit const std::string_view kVersion = GANGLION_VERSION;

}  // namespace ganglion
