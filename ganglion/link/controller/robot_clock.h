#pragma once

#include <cstdint>

#include "ganglion/base/sentence.h"

namespace ganglion::link {

/// The time of a robot elsewhere, made to grow from frame to frame whatever its clock does, so that no old reading is
/// ever taken for new, nor a new one for old. A clock of 32 bits of microseconds or milliseconds that wraps is carried
/// on. One that is set back or jumps is taken up again where the frame was due. One that stands tells nothing: the time
/// goes on, and what is read grows old with it. One that does such things again and again is no clock at all.
class RobotClock {
 public:
  enum class Step : std::uint8_t { Regular, Wrapped, Stood, WentBack, Jumped };

  /// A count begins: the first frame after a greeting or a reset, believed as it is. What is no number counts as 0.
  void start(double told_s) noexcept;
  /// The next frame: how long after the last one it was due by the ticks between them, and by our own clock, which a
  /// robot that waits for commands may follow. A clock may be late or early by half of it and a second.
  Step take(double told_s, double due_s, double waited_s) noexcept;

  /// Of the last frame [s]; a regular clock's own.
  double time_s() const noexcept { return time_s_; }
  /// For how long it has stood: readings are that much older than they are said to be [s].
  double stood_s() const noexcept { return stood_s_; }
  /// Whether it can be of no more use.
  bool hopeless() const noexcept { return doubt_ >= kMostDoubt; }
  /// What it did, for the log, or as the reason why it is hopeless.
  Sentence words(Step step) const;
  /// Whether the last frame was the first irregular one after regular ones: once is enough for the log.
  bool news() const noexcept { return news_; }

 private:
  static constexpr int kDoubt = 3;      // of an irregular frame; a regular one takes 1 away
  static constexpr int kMostDoubt = 9;  // three in a row

  double told_s_ = 0, before_s_ = 0;  // of the last frame and of the one before
  double offset_s_ = 0;               // between the robot's clock and time_s_
  double time_s_ = 0, stood_s_ = 0, due_s_ = 0;
  int doubt_ = 0;
  bool news_ = false;
};

}  // namespace ganglion::link
