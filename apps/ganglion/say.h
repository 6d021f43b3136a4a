#pragma once

#include <string>

#include "ganglion/base/result.h"

namespace ganglion {

/// A line on standard output, in the user's language.
void put(const Sentence& line);
template <class... Args>
void tell(Wording<std::type_identity_t<Args>...> words, const Args&... args) {
  put(say<Args...>(words, args...));
}
/// A line on standard error, control characters made visible.
void note(const Sentence& line);

/// What a file says, in the user's language where it has it.
const std::string& recorded(const Sentence& words) noexcept;

/// Problems on standard error, one a line. Returns kBadInput.
int complain(const Problems& problems);
/// Returns kOutputFailed for what could not be written, kLinkLostCode for a robot that cannot be reached, else
/// kBadInput.
int complain(const Error& error);

/// A line on standard error that replaces itself while something long goes on; silent where it is no terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool wanted);
  ~ProgressLine();
  /// `share` of the work done in [0, 1]; `rate` is said behind it, e.g. "240x real time".
  void show(double share, const Sentence& rate);

 private:
  bool on_;
  double start_s_;
  double shown_s_ = -1;
};

/// Seconds of the steady clock, for rates shown to people.
double wall_s();

}  // namespace ganglion
