#include "ganglion/experience/lease.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

#include "ganglion/base/text.h"

namespace ganglion {
namespace {

std::string content_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Status {
  char state = '?';
  std::string started;
};

/// What /proc tells of a process: fields 3 and 22, counted from behind the name, which may hold anything.
Status status_of(std::int64_t process) {
  constexpr int kStarted = 22 - 3;
  const std::string all = content_of(fmt::format("/proc/{}/stat", process));
  std::istringstream fields(all.substr(std::min(all.rfind(')'), all.size() - 1) + 1));
  Status status;
  fields >> status.state;
  for (int i = 0; i < kStarted && fields; ++i) fields >> status.started;
  if (!fields) return {};
  status.started += " " + std::string(trimmed(content_of("/proc/sys/kernel/random/boot_id")));
  return status;
}

}  // namespace

ProcessMark this_process() { return {::getpid(), status_of(::getpid()).started}; }

bool is_alive(const ProcessMark& process) {
  if (process.number <= 0 || process.number > std::numeric_limits<pid_t>::max()) return false;
  if (::kill(static_cast<pid_t>(process.number), 0) != 0 && errno == ESRCH) return false;
  const Status now = status_of(process.number);
  const bool ended = now.state == 'Z' || now.state == 'X';
  return !ended && now.started == process.started;
}

}  // namespace ganglion
