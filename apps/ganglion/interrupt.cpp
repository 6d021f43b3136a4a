#include "interrupt.h"

#include <csignal>

namespace ganglion {
namespace {

volatile std::sig_atomic_t caught = 0;

void take_signal(int) { caught = 1; }

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, take_signal);
  std::signal(SIGTERM, take_signal);
}

void report_full_files() { std::signal(SIGXFSZ, SIG_IGN); }

bool interrupted() noexcept { return caught != 0; }

}  // namespace ganglion
