#include "ganglion/link/controller/robot_clock.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ganglion::link {
namespace {

constexpr double kSlack_s = 1;
/// Where counters of 32 bits begin again: of microseconds after 71 min 35 s, of milliseconds after 49.7 days.
constexpr std::array kSpans_s = {4294.967296, 4294967.296};

bool regular(double gone_s, double due_s, double waited_s) noexcept {
  return gone_s > 0 && gone_s >= 0.1 * due_s && gone_s <= 1.5 * std::max(due_s, waited_s) + kSlack_s;
}

}  // namespace

void RobotClock::start(double told_s) noexcept {
  *this = RobotClock();
  time_s_ = told_s_ = std::isfinite(told_s) ? told_s : 0;
}

RobotClock::Step RobotClock::take(double told_s, double due_s, double waited_s) noexcept {
  if (!std::isfinite(told_s)) told_s = told_s_;
  const double gone_s = told_s - told_s_;
  before_s_ = told_s_;
  told_s_ = told_s;
  due_s_ = due_s;
  const auto wrapped = std::find_if(kSpans_s.begin(), kSpans_s.end(), [&](double span_s) {
    return gone_s < 0 && regular(gone_s + span_s, due_s, waited_s);
  });
  if (wrapped != kSpans_s.end()) offset_s_ += *wrapped;
  if (wrapped != kSpans_s.end() || regular(gone_s, due_s, waited_s)) {
    time_s_ = told_s + offset_s_;
    stood_s_ = 0;
    doubt_ = std::max(0, doubt_ - 1);
    news_ = wrapped != kSpans_s.end();
    return news_ ? Step::Wrapped : Step::Regular;
  }
  time_s_ += due_s;
  offset_s_ = time_s_ - told_s;
  news_ = doubt_ == 0;
  doubt_ += kDoubt;
  const Step step = gone_s > 0.1 * due_s ? Step::Jumped : gone_s < 0 ? Step::WentBack : Step::Stood;
  stood_s_ = step == Step::Stood ? stood_s_ + due_s : 0;
  return step;
}

Sentence RobotClock::words(Step step) const {
  const double by_s = std::abs(told_s_ - before_s_);
  switch (step) {
    case Step::Wrapped:
      return say(
          {"the robot's clock began again at {:g} s after {:g} s, as a counter of 32 bits does: the time goes on",
           "el reloj del robot volvió a empezar en {:g} s tras {:g} s, como un contador de 32 bits: el tiempo "
           "sigue"},
          told_s_, before_s_);
    case Step::WentBack:
      return say({"the robot's clock went back by {:g} s, to {:g} s, where {:g} s had to pass",
                  "el reloj del robot retrocedió {:g} s, hasta {:g} s, cuando debían pasar {:g} s"},
                 by_s, told_s_, due_s_);
    case Step::Jumped:
      return say({"the robot's clock jumped by {:g} s, to {:g} s, where {:g} s had to pass: are these seconds?",
                  "el reloj del robot saltó {:g} s, hasta {:g} s, cuando debían pasar {:g} s: ¿son segundos?"},
                 by_s, told_s_, due_s_);
    case Step::Stood:
      return say(
          {"the robot's clock stands at {:g} s, where {:g} s had to pass: its Sense must tell time_s (or time_ms), "
           "so that old readings can be told from new ones",
           "el reloj del robot está parado en {:g} s, cuando debían pasar {:g} s: su Sense debe decir time_s (o "
           "time_ms), para distinguir las lecturas viejas de las nuevas"},
          told_s_, due_s_);
    case Step::Regular:
      break;
  }
  return {};
}

}  // namespace ganglion::link
