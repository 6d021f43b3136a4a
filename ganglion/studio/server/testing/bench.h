#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <memory>

#include "ganglion/studio/server/server.h"
#include "ganglion/studio/server/testing/client.h"

namespace ganglion::studio {

/// A server on a copy of the nimrod experiment, and a folder beside it that it must not touch.
class ServerTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    root_ = std::filesystem::path(::testing::TempDir()) /
            (std::string("studio_") + test->name() + "_" + std::to_string(::getpid()));
    std::filesystem::remove_all(root_);
    std::filesystem::create_directories(outside());
    std::filesystem::create_directories(folder());
    for (const auto& entry : std::filesystem::directory_iterator(GANGLION_SOURCE_DIR "/experiments/nimrod")) {
      std::filesystem::copy(entry.path(), folder() / entry.path().filename());
    }
  }
  void TearDown() override {
    server_.reset();
    std::filesystem::remove_all(root_);
  }

  std::filesystem::path folder() const { return root_ / "inside"; }
  std::filesystem::path outside() const { return root_ / "outside"; }

  Client client_of(ServerOptions options = {}) {
    options.folder = folder();
    auto server = Server::start(options);
    EXPECT_TRUE(server) << server.error().text();
    server_ = std::move(*server);
    return {server_->port(), server_->token(), {}};
  }
  Server& server() { return *server_; }

 private:
  std::filesystem::path root_;
  std::unique_ptr<Server> server_;
};

}  // namespace ganglion::studio
