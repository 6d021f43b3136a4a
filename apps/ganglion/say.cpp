#include "say.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>

#include "commands.h"

namespace ganglion {

int complain(const Problems& problems) {
  const auto errors = problems.sorted();
  for (const Error& error : errors) std::fprintf(stderr, "%s\n", error.text().c_str());
  if (errors.size() > 1) std::fprintf(stderr, "%zu problems\n", errors.size());
  return kBadInput;
}

int complain(const Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  if (error.code == ErrorCode::LinkLost) return kLinkLostCode;
  return error.code == ErrorCode::Unwritable ? kOutputFailed : kBadInput;
}

double wall_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

ProgressLine::ProgressLine(bool wanted) : on_(wanted && ::isatty(STDERR_FILENO) == 1), start_s_(wall_s()) {}

ProgressLine::~ProgressLine() {
  if (on_ && shown_s_ >= 0) std::fprintf(stderr, "\r\033[K");
}

void ProgressLine::show(double share, const std::string& rate) {
  const double now_s = wall_s() - start_s_;
  if (!on_ || share <= 0 || now_s - shown_s_ < 0.1) return;
  shown_s_ = now_s;
  std::fprintf(stderr, "\r\033[K%3.0f %%  %s  %.0f s left", share * 100, rate.c_str(), now_s * (1 / share - 1));
  std::fflush(stderr);
}

}  // namespace ganglion
