#pragma once

#include <optional>

#include "ganglion/link/controller/line.h"
#include "ganglion/link/robot/robot_end.h"

namespace ganglion::link {

/// A line to a robot's end in this program, with a clock that only goes when somebody waits, and that can be cut.
class MemoryLine final : public Line {
 public:
  enum class Way : std::uint8_t { ToRobot, ToController };
  enum class CutBy : std::uint8_t {
    Fin,      ///< In order: what was sent before still arrives.
    Rst,      ///< What is on its way is lost, both ways.
    Silence,  ///< Bytes vanish from then on, and nobody is told.
  };
  struct Cut {
    Way way = Way::ToRobot;
    std::size_t at = 0;  ///< Bytes that still get through on that way.
    CutBy by = CutBy::Fin;
  };
  /// The robot's end outlives it.
  explicit MemoryLine(RobotEnd& end, Carrier carrier = Carrier::Stream) : end_(end), carrier_(carrier) {}

  void cut(Cut cut) { cut_ = cut; }
  /// On a line that loses bytes: every so many are changed.
  void spoil_every(std::size_t bytes) { spoil_every_ = bytes; }
  std::size_t carried(Way way) const noexcept { return carried_[static_cast<std::size_t>(way)]; }
  int connections() const noexcept { return connections_; }
  /// When the robot was reached last.
  double delivered_s() const noexcept { return delivered_s_; }
  void unplug() { plugged_ = false; }

  Carrier carrier() const noexcept override { return carrier_; }
  const std::string& address() const noexcept override { return address_; }
  double now_s() noexcept override { return now_s_; }
  Result<void> connect(double until_s) override;
  void close() noexcept override;
  Result<void> send(std::string_view bytes, double until_s) override;
  Result<std::size_t> receive(std::span<char> room, double until_s) override;
  void wait_until(double until_s) override;

 private:
  /// Bytes as they arrive: up to the cut, which then happens.
  std::string passed(Way way, std::string_view bytes);
  void fetch();
  bool broken() const noexcept { return !open_ || finished_ || reset_; }

  RobotEnd& end_;
  Carrier carrier_;
  std::string address_ = "memory";
  std::optional<Cut> cut_;
  std::optional<RobotEnd::PeerId> peer_;
  std::string inbox_;  // for the controller
  double now_s_ = 0;
  double delivered_s_ = 0;
  std::size_t carried_[2] = {0, 0};
  std::size_t spoil_every_ = 0;
  int connections_ = 0;
  bool open_ = false, plugged_ = true;
  bool finished_ = false, reset_ = false, silent_ = false;
};

}  // namespace ganglion::link
