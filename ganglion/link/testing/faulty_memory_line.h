#pragma once

#include <deque>

#include "ganglion/link/controller/line.h"
#include "ganglion/link/fault/faulty_connection.h"
#include "ganglion/link/robot/robot_end.h"

namespace ganglion::link {

/// A line to a robot's end in this program that goes through faults, with a clock that only goes when somebody waits.
/// What a closed connection still carries arrives all the same, as between two machines.
class FaultyMemoryLine final : public Line {
 public:
  /// The robot's end outlives it.
  FaultyMemoryLine(RobotEnd& end, const LineFaults& faults, std::uint64_t seed, Carrier carrier)
      : end_(end), faults_(faults), seed_(seed), carrier_(carrier) {}

  /// Told each piece that arrives, before it is read.
  std::function<void(Way, std::uint32_t connection, std::string_view bytes, double now_s)> arriving;
  /// All that arrived, its times included, as one number.
  std::uint64_t log_hash() const noexcept { return log_hash_; }
  int connections() const noexcept { return static_cast<int>(next_number_); }
  /// The latest struck_s() of its connections.
  double struck_s() const noexcept { return struck_s_; }

  Carrier carrier() const noexcept override { return carrier_; }
  const std::string& address() const noexcept override { return address_; }
  double now_s() noexcept override { return now_s_; }
  Result<void> connect(double until_s) override;
  void close() noexcept override;
  Result<void> send(std::string_view bytes, double until_s) override;
  Result<std::size_t> receive(std::span<char> room, double until_s) override;
  void wait_until(double until_s) override;

 private:
  struct Connection {
    Connection(FaultyConnection through, RobotEnd::PeerId with, std::uint32_t its_number)
        : way(std::move(through)), peer(with), number(its_number) {}
    FaultyConnection way;
    RobotEnd::PeerId peer;
    std::uint32_t number;
    bool robot_gone = false;       // the robot's side was closed
    bool current = true;           // the controller's
    bool controller_gone = false;  // told the controller that nothing follows
  };
  /// Carries what is due both ways, as far as it goes without time passing.
  void carry();
  bool carry(Connection& connection);
  bool deliver(Connection& connection, Way way);
  double due_s() const;
  Connection* current() noexcept;
  void log(Way way, const Connection& connection, std::string_view bytes, bool end);

  RobotEnd& end_;
  LineFaults faults_;
  std::uint64_t seed_;
  Carrier carrier_;
  std::string address_ = "memory";
  std::deque<Connection> connections_;
  std::uint32_t next_number_ = 0;
  std::string inbox_;
  double now_s_ = 0, struck_s_ = 0;
  std::uint64_t log_hash_ = 0, rounds_ = 0;
};

}  // namespace ganglion::link
