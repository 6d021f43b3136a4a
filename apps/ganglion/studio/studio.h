#pragma once

#include "ganglion/studio/server/server.h"

namespace ganglion {

/// Prints the URL, and opens it where there is a browser to open it with.
void announce_studio(const studio::Server& server, bool browser);

}  // namespace ganglion
