#pragma once

#include <deque>
#include <optional>
#include <string>

#include "ganglion/base/sentence.h"
#include "ganglion/link/fault/frame_cutter.h"
#include "ganglion/link/fault/line_fault.h"
#include "ganglion/random/draws.h"

namespace ganglion::link {

enum class Way : std::uint8_t { ToRobot, ToController };

/// What became of the frames of one way.
struct FaultCounts {
  std::uint32_t frames = 0;
  std::uint32_t lost = 0, duplicated = 0, merged = 0, split = 0;
  std::uint32_t corrupted_bytes = 0;
  /// "41 frames, 2 lost, 1 duplicated".
  Sentence text() const;
};

/// One connection on its way through faults: takes bytes and times, gives bytes and times. It knows no socket and no
/// clock, and depends on nothing but seed, number of the connection, and the frames that pass: the same frames at the
/// same times give the same again. Each fault draws for itself, frame by frame.
class FaultyConnection {
 public:
  struct Arrival {
    std::string bytes;
    bool end = false;  ///< That side said all it had to say; nothing follows.
  };
  /// Connections are numbered from 0. Lines of packets do not end: there `fin` does nothing, and `rst` loses what is
  /// under way.
  FaultyConnection(const LineFaults& faults, std::uint64_t seed, std::uint32_t number, Carrier carrier);

  /// Bytes set out. `now_s` never goes back.
  void push(Way way, std::string_view bytes, double now_s);
  /// Who sends that way has closed.
  void finish(Way way, double now_s);
  /// What arrives by now, one piece at a time; none when that was all.
  std::optional<Arrival> take(Way way, double now_s);
  /// The connection was cut off at once: both sides are to be told so, and nothing arrives any more.
  bool reset() const noexcept { return reset_; }
  /// When something arrives next; infinite where nothing is under way.
  double due_s() const noexcept;
  /// Bytes under way.
  std::size_t pending(Way way) const noexcept { return of(way).pending; }
  const FaultCounts& counts(Way way) const noexcept { return of(way).counts; }
  /// When something was last lost, changed, doubled, cut off, or held back by a freeze (which counts to its end).
  /// Delays do not count.
  double struck_s() const noexcept { return struck_s_; }

 private:
  struct Parcel {
    double at_s = 0;
    std::string bytes;
    bool end = false;
    bool merges = false;   // waits for the next one
    double set_out_s = 0;  // when it would arrive if it did not wait
  };
  struct Direction {
    explicit Direction(Carrier carrier) : cutter(carrier) {}
    FrameCutter cutter;
    std::deque<Parcel> under_way;
    std::size_t pending = 0;
    std::uint32_t frame = 0;  // number of the next one
    double last_s = 0;        // arrival of the one before: order is kept
    bool ended = false;
    FaultCounts counts;
  };
  Direction& of(Way way) noexcept { return directions_[static_cast<std::size_t>(way)]; }
  const Direction& of(Way way) const noexcept { return directions_[static_cast<std::size_t>(way)]; }
  /// Whether a fault that happens to a share of the frames happens to this one.
  bool happens(double LineFault::*share, std::string_view name, Way way, double now_s) const;
  Draws draws(std::size_t fault, std::string_view name, Way way) const;
  bool acts(const LineFault& fault, Way way, double at_s) const noexcept;
  bool muted(Way way, double now_s) const noexcept;
  /// When what sets out now arrives.
  double arrival_s(Way way, double now_s);
  void carry(Way way, std::string frame, double now_s);
  void corrupt(Way way, std::string& frame, double now_s);
  void dispatch(Way way, const std::string& frame, double now_s);
  void put(Way way, Parcel parcel);
  bool cut(Way way, const std::string& frame, double now_s);
  void strike(double at_s) noexcept { struck_s_ = at_s > struck_s_ ? at_s : struck_s_; }

  LineFaults faults_;
  std::uint64_t seed_;
  std::uint32_t number_;
  Carrier carrier_;
  Direction directions_[2];
  bool reset_ = false;
  double struck_s_ = 0;
};

}  // namespace ganglion::link
