#pragma once

#include <cstdint>
#include <string>

namespace ganglion {

/// A process of this machine, told from a later one that got the same number.
struct ProcessMark {
  std::int64_t number = 0;
  std::string started;  ///< When, in the kernel's words; "" where they cannot be had.
  friend bool operator==(const ProcessMark&, const ProcessMark&) = default;
};

ProcessMark this_process();
/// False of one that ended, and of one of before the machine was started anew.
bool is_alive(const ProcessMark& process);

/// Who may write to a store: one at a time. It lapses when its process dies.
struct Lease {
  std::string owner;  ///< "pathfinder": the run it belongs to; "" = nobody's.
  ProcessMark process;
  std::int64_t since_s = 0;  ///< Seconds since 1970.
  friend bool operator==(const Lease&, const Lease&) = default;
};

}  // namespace ganglion
