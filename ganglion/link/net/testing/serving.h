#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>

#include "ganglion/link/net/server.h"

namespace ganglion::link {

/// Serves a robot's end by a thread of its own, until stop() or the end of its life.
class Serving {
 public:
  explicit Serving(RobotEnd& end, const std::string& at = "127.0.0.1:0") {
    auto server = Server::listen(end, *parse_address(at));
    EXPECT_TRUE(server) << server.error().what.en;
    server_ = std::move(*server);
    thread_ = std::jthread([this](const std::stop_token& stop) {
      server_->serve([&stop] { return stop.stop_requested(); }, say({"the test is over", "la prueba terminó"}));
    });
  }
  void stop() {
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
  }
  const Address& address() const { return server_->address(); }

 private:
  std::unique_ptr<Server> server_;
  std::jthread thread_;  // the last, so that it ends before what it uses
};

}  // namespace ganglion::link
