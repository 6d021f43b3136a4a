#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "clients/c/ganglion_robot.h"
#include "ganglion/link/wire/codec.h"

namespace ganglion::link {

/// A robot made of clients/c, with a notebook for hardware, spoken to by our own codec. Its buffers lie on the heap at
/// their exact sizes, so that a sanitizer sees any step beyond them.
class CRobot {
 public:
  struct Options {
    bool can_lock_step = true;
    int sensations = 4;
  };
  CRobot() : CRobot(Options{}) {}
  explicit CRobot(Options options);
  CRobot(const CRobot&) = delete;
  CRobot& operator=(const CRobot&) = delete;

  /// Bytes as they come from the line, at the time now_ms.
  void receive(std::string_view bytes);
  template <class Message>
  void say(const Message& message) {
    std::string bytes;
    written(writer_.append(message, bytes));
    receive(bytes);
  }
  void poll() { ganglion_robot_poll(&robot_, now_ms); }
  /// The next frame it sent; Unknown: there is none. The message is in `in`.
  FrameKind next();
  /// The last frame it sent.
  FrameKind last();
  /// What a controller says first; answers are read and gone, the token kept.
  void greet(wire::Pace pace);
  bool connected() const noexcept { return connected_; }

  std::uint32_t now_ms = 1000;
  std::vector<float> sensed = {1.5F, -0.5F, 2.0F, 0.0F};  ///< What it will sense.
  std::vector<float> done;                                ///< Commands it carries out.
  std::vector<std::uint32_t> steps_ms;                    ///< Of lock-step.
  int acts = 0, resets = 0;
  std::string out, token;
  Messages in;

 private:
  static void written(const Result<void>& result);
  std::vector<std::uint8_t> frame_;
  std::vector<float> out_;
  ganglion_robot_config config_{};
  ganglion_robot robot_{};
  FrameWriter writer_;
  FrameReader reader_;
  bool connected_ = true;
};

}  // namespace ganglion::link
