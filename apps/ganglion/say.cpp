#include "say.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>

#include "commands.h"
#include "ganglion/base/text.h"
#include "language.h"

namespace ganglion {
namespace {

void write_line(std::FILE* to, std::string line) {
  line += '\n';
  std::fwrite(line.data(), 1, line.size(), to);
}

}  // namespace

void put(const Sentence& line) { write_line(stdout, line.in(language())); }

void note(const Sentence& line) { write_line(stderr, printable(line.in(language()))); }

const std::string& recorded(const Sentence& words) noexcept {
  return words.es.empty() ? words.en : words.in(language());
}

int complain(const Problems& problems) {
  const auto errors = problems.sorted();
  for (const Error& error : errors) write_line(stderr, error.text(language()));
  if (errors.size() > 1) note(say({"{} problems", "{} problemas"}, errors.size()));
  return kBadInput;
}

int complain(const Error& error) {
  write_line(stderr, error.text(language()));
  if (error.code == ErrorCode::LinkLost) return kLinkLostCode;
  return error.code == ErrorCode::Unwritable ? kOutputFailed : kBadInput;
}

double wall_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

ProgressLine::ProgressLine(bool wanted) : on_(wanted && ::isatty(STDERR_FILENO) == 1), start_s_(wall_s()) {}

ProgressLine::~ProgressLine() {
  if (on_ && shown_s_ >= 0) std::fprintf(stderr, "\r\033[K");
}

void ProgressLine::show(double share, const Sentence& rate) {
  const double now_s = wall_s() - start_s_;
  if (!on_ || share <= 0 || now_s - shown_s_ < 0.1) return;
  shown_s_ = now_s;
  const Sentence line = say({"{:3.0f} %  {}  {:.0f} s left", "{:3.0f} %  {}  quedan {:.0f} s"}, share * 100, rate,
                            now_s * (1 / share - 1));
  std::fprintf(stderr, "\r\033[K%s", line.in(language()).c_str());
  std::fflush(stderr);
}

}  // namespace ganglion
