#pragma once

#include <functional>
#include <memory>

#include "ganglion/link/controller/channel_map.h"
#include "ganglion/link/controller/controller_end.h"
#include "ganglion/link/controller/line.h"
#include "ganglion/link/controller/remote_witness.h"
#include "ganglion/link/controller/robot_clock.h"
#include "ganglion/link/wire/description.h"

namespace ganglion::link {

struct RemoteConfig {
  ControllerEndConfig end;
  double reach_s = 0;          ///< How long to try to reach it the first time: for robots that are just being started.
  std::function<bool()> stop;  ///< Asked while waiting; true gives up.
  HopedTruth truth;            ///< What the file knows of it besides; whoever does not tell it is driven without.
};

/// Robots at the other end of a line, as an application. What breaks on the way is mended while it can be; then
/// failure() tells, frames keep what came last, and commands go nowhere. Once warm, binary frames take no memory.
class RemoteApplication final : public Application {
 public:
  /// Connects and compares what the robot says of itself with the file a controller was drawn for. Fails with LinkLost,
  /// in words that say what to do, also where the controller could not drive it.
  static Result<std::unique_ptr<RemoteApplication>> connect(std::unique_ptr<Line> line, const Description& file,
                                                            int robots, const RemoteConfig& config);
  /// Says goodbye, so that the robot takes its safe values at once.
  ~RemoteApplication() override;
  RemoteApplication(const RemoteApplication&) = delete;
  RemoteApplication& operator=(const RemoteApplication&) = delete;

  const Description& description() const noexcept override { return file_; }
  int robots() const noexcept override { return robots_; }
  Result<void> reset(std::uint64_t seed, std::uint32_t episode) override;
  void sense(std::span<SenseFrame> frames) noexcept override;
  void step(std::span<const ActFrame> frames, double step_s) noexcept override;
  /// Between ticks, while a run is held back: takes what has come and sends heartbeats, each second, so that the robot
  /// gives the place of its commander to nobody else. Waits for nothing; a broken connection is mended by what comes next.
  void stay_in_touch() noexcept;
  const Error* failure() const noexcept override { return end_.failure() ? &*end_.failure() : nullptr; }

  /// Null where the robot does not tell it.
  const Witness* witness() const noexcept override { return witness_.get(); }
  const LinkStatistics& statistics() const noexcept { return end_.statistics(); }
  /// What the robot told since the last call.
  std::vector<wire::Event> take_events() { return end_.take_events(); }
  /// Where the robot is not what the file says, but can be driven.
  const std::vector<Difference>& differences() const noexcept { return differences_; }

 private:
  RemoteApplication(std::unique_ptr<Line> line, const Description& file, int robots, const RemoteConfig& config);
  Result<void> greet();
  Result<void> compare();
  /// Carries bytes until what was asked for is there, or the end has failed.
  void await() noexcept;
  bool reconnect() noexcept;
  void flush() noexcept;
  /// Takes what has come, without waiting.
  void drain() noexcept;
  void take_sense(bool first) noexcept;
  /// Gives the frames a time that grows, and readings that have no older time the age they have.
  void tell_time(bool first) noexcept;
  Error error() const;

  std::unique_ptr<Line> line_;
  Description file_;
  int robots_;
  RemoteConfig config_;
  ControllerEnd end_;
  std::vector<Difference> differences_;
  std::optional<ChannelMap> map_;
  std::unique_ptr<RemoteWitness> witness_;
  std::vector<SenseFrame> sense_;  // as the robot describes them
  std::vector<ActFrame> act_;
  RobotClock clock_;
  double asked_step_s_ = 0;  // of the last act
  double taken_s_ = 0;       // by our clock, when the last Sense was taken
  std::uint32_t taken_tick_ = 0;
  std::vector<char> room_;
  double tried_s_ = 0;  // to connect
};

/// The text of each, "; " between.
Sentence text_of(const std::vector<Difference>& differences);

}  // namespace ganglion::link
