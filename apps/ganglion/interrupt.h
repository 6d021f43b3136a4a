#pragma once

namespace ganglion {

/// From now on ctrl-C and SIGTERM do not end the program but make this true, so that runs end with a whole file.
void catch_interrupts();
bool interrupted() noexcept;

/// Where a limit on the size of files is reached, writing fails with a message instead of ending the program.
void report_full_files();

}  // namespace ganglion
