#pragma once

namespace ganglion {

/// From now on ctrl-C and SIGTERM do not end the program but make this true, so that runs end with a whole file.
void catch_interrupts();
bool interrupted() noexcept;

}  // namespace ganglion
