#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <mutex>
#include <thread>

#include "ganglion/base/file.h"
#include "ganglion/link/net/lines.h"
#include "ganglion/link/net/program.h"
#include "ganglion/link/net/server.h"
#include "ganglion/run/run_robots.h"
#include "ganglion/studio/server/testing/bench.h"
#include "ganglion/studio/server/testing/child_server.h"

namespace ganglion::studio {
namespace {

using Link = ServerTest;

/// What a robot was told to do, and when.
struct Order {
  double at_s = 0;
  bool commanded = false;
};

/// Keeps a record of all that an application is told.
class Recorder final : public Application {
 public:
  explicit Recorder(Application& inner) : inner_(inner) {}
  const Description& description() const noexcept override { return inner_.description(); }
  int robots() const noexcept override { return inner_.robots(); }
  Result<void> reset(std::uint64_t seed, std::uint32_t episode) override { return inner_.reset(seed, episode); }
  void sense(std::span<SenseFrame> frames) noexcept override { inner_.sense(frames); }
  void step(std::span<const ActFrame> frames, double step_s) noexcept override {
    {
      const std::lock_guard lock(mutex_);
      const ActFrame& act = frames.front();
      orders_.push_back({link::steady_s(), act.origins.front() == CommandOrigin::Commanded});
    }
    inner_.step(frames, step_s);
  }
  const Witness* witness() const noexcept override { return inner_.witness(); }
  std::vector<Order> orders() const {
    const std::lock_guard lock(mutex_);
    return orders_;
  }

 private:
  Application& inner_;
  mutable std::mutex mutex_;
  std::vector<Order> orders_;
};

/// What `ganglion sim` does, in a thread: the nimrod behind an address.
class Robot {
 public:
  explicit Robot(const std::filesystem::path& experiment, const std::string& change = "") {
    std::vector<config::Override> overrides;
    if (!change.empty()) overrides.push_back(*config::parse_override(change));
    Problems problems;
    prepared_ = prepare(experiment, overrides, problems).value();
    application_ = prepared_.application->make().value();
    EXPECT_TRUE(application_->reset(1, 0));
    recorder_.emplace(*application_);
    link::RobotEndConfig config;
    config.token = link::random_token;
    end_.emplace(*recorder_, config);
    server_ = std::move(link::Server::listen(*end_, *link::parse_address("127.0.0.1:0")).value());
    thread_ = std::jthread([this] {
      server_->serve([this] { return stop_.load(); }, say({"the simulation was ended", "se terminó la simulación"}));
    });
  }
  ~Robot() { stop(); }
  void stop() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    server_.reset();
  }
  std::string address() const { return server_->address().text; }
  const Recorder& recorder() const { return *recorder_; }

 private:
  Prepared prepared_;
  std::unique_ptr<Application> application_;
  std::optional<Recorder> recorder_;
  std::optional<link::RobotEnd> end_;
  std::unique_ptr<link::Server> server_;
  std::atomic<bool> stop_ = false;
  std::jthread thread_;
};

Json final_test(Watcher& watcher) {
  while (auto event = watcher.event("link", 60)) {
    if ((*event)["done"]) return *event;
  }
  return {};
}

Json final_state(Watcher& watcher) {
  while (auto event = watcher.event("run", 60)) {
    if ((*event)["state"]["state"] == "done") return (*event)["state"];
  }
  return {};
}

TEST_F(Link, TellsWhatARobotOffersHowFastItAnswersAndWhatDiffers) {
  const Client client = client_of();
  Robot robot(folder() / "experiment.toml", "application.robot.tick_s=0.05");
  Watcher watcher(client);
  const Answer begun = client.post("/api/link/test", {{"experiment", "experiment.toml"}, {"address", robot.address()}});
  ASSERT_EQ(begun.status, 200u) << begun.body;
  EXPECT_EQ(begun.json()["test"]["done"], false);
  EXPECT_EQ(client.get("/api/files").status, 200u) << "the server goes on answering";
  const Json test = final_test(watcher);
  EXPECT_TRUE(test["good"]) << test.dump();
  const std::string all = test["findings"].dump();
  for (const char* expected :
       {"takes connections", "it is \\\"Nimrod\\\"", "sonar_left.range [m]", "it takes the commands drive",
        "it answers within", "it differs: tick_s: the robot has 0.05, the file 0.1", "a controller can drive it"}) {
    EXPECT_NE(all.find(expected), std::string::npos) << expected << "\n" << all;
  }
  EXPECT_EQ(client.get("/api/link").json()["test"]["findings"], test["findings"]);
  for (const Order& order : robot.recorder().orders()) EXPECT_FALSE(order.commanded) << "it was moved";
}

TEST_F(Link, SaysInSpanishThatNobodyIsThereAndWhatToDo) {
  const Client client = client_of();
  Watcher watcher(client);
  const std::string nobody = "tcp://127.0.0.1:" + std::to_string(link::free_port().value());
  ASSERT_EQ(client.post("/api/link/test", {{"address", nobody}, {"language", "es"}}).status, 200u);
  const Json test = final_test(watcher);
  EXPECT_FALSE(test["good"]);
  const std::string words = test["findings"][0]["message"];
  EXPECT_TRUE(words.starts_with("nada responde en " + nobody)) << words;
  EXPECT_NE(words.find("ganglion sim"), std::string::npos) << words;
}

TEST_F(Link, TriesTheSimulationByReadingItsFiles) {
  const Client client = client_of();
  const Json good = client.post("/api/link/test", {{"experiment", "experiment.toml"}, {"address", ""}}).json()["test"];
  EXPECT_TRUE(good["done"] && good["good"]) << good.dump();
  const Json bad =
      client
          .post("/api/link/test",
                {{"experiment", "experiment.toml"},
                 {"controller",
                  {{"path", "controller.toml"}, {"text", "format = 1\n[[acting]]\nid = \"a\"\nkind = \"Nothing\"\n"}}}})
          .json()["test"];
  EXPECT_FALSE(bad["good"]);
  EXPECT_FALSE(bad["findings"].empty());
}

TEST_F(Link, GoesNowhereButToRobots) {
  const std::filesystem::path list = outside() / "studio.toml";
  ASSERT_TRUE(write_file(list, "format = 1\n[[program]]\nname = \"mine\"\ncommand = [\"/bin/false\", \"{port}\"]\n"));
  const Client client = client_of({.programs = list});
  const std::string long_one = "tcp://" + std::string(100'000, 'a') + ":80";
  const std::string hostile("tcp://a\0b:80", 12);
  for (const std::string& address :
       {std::string("http://127.0.0.1:80/"), std::string("file:///etc/passwd"), std::string("unix:/run/x.sock"),
        std::string("serial:///etc/passwd"), std::string("serial:///dev/tty/../sda"), std::string("serial://tty"),
        std::string("tcp://127.0.0.1:99999"), std::string("tcp://$(id):80"), std::string("tcp://a b:80"),
        std::string("-oProxy:80/x"), std::string("<script>:1"), hostile, long_one + "/", std::string("ñ:80")}) {
    for (const char* path : {"/api/link/test", "/api/run/start"}) {
      const Answer answer = client.post(path, {{"experiment", "experiment.toml"}, {"address", address}});
      EXPECT_EQ(answer.status, 403u) << path << " " << address.substr(0, 80) << " " << answer.body;
    }
    EXPECT_EQ(client.post("/api/link/test", {{"address", address}}).status, 403u) << address.substr(0, 80);
  }
  for (const char* program : {"/bin/touch", "", "mine ", "../mine"}) {
    EXPECT_EQ(client.post("/api/link/test", {{"program", program}}).json()["error"]["code"], "ProgramNotListed");
  }
  const Json both = {{"program", "mine"}, {"address", "127.0.0.1:80"}};
  EXPECT_EQ(client.post("/api/link/test", both).status, 400u);
  EXPECT_EQ(client.post("/api/link/test", {}).status, 400u);
  const Json by_set = {{"experiment", "experiment.toml"}, {"set", {"application={address=\"serial:///etc/passwd\"}"}}};
  EXPECT_EQ(client.post("/api/link/test", by_set).status, 403u);
  EXPECT_TRUE(client.get("/api/link").json()["test"].is_null()) << "nothing was tried";
}

TEST_F(Link, StartsAListedProgramForTheTestAndSaysHowItEnded) {
  const std::filesystem::path list = outside() / "studio.toml";
  ASSERT_TRUE(write_file(list,
                         "format = 1\n[[program]]\nname = \"mine\"\n"
                         "command = [\"/bin/sh\", \"-c\", \"echo no motor at port {port}; exit 3\"]\n"));
  const Client client = client_of({.programs = list});
  Watcher watcher(client);
  ASSERT_EQ(client.post("/api/link/test", {{"experiment", "experiment.toml"}, {"program", "mine"}}).status, 200u);
  const Json test = final_test(watcher);
  EXPECT_FALSE(test["good"]);
  EXPECT_NE(test.dump().find("the program ended and last said: no motor at port "), std::string::npos) << test.dump();
}

TEST_F(Link, OneTestAtATime) {
  const Client client = client_of();
  Watcher watcher(client);
  // It takes connections, but is no robot: this very server.
  const Json silent = {{"address", "127.0.0.1:" + std::to_string(client.port)}};
  ASSERT_EQ(client.post("/api/link/test", silent).status, 200u);
  const Answer second = client.post("/api/link/test", silent);
  EXPECT_EQ(second.status, 409u) << second.body;
  EXPECT_EQ(client.get("/api/files").status, 200u);
  EXPECT_FALSE(final_test(watcher)["good"]);
}

TEST_F(Link, ARunOverAnAddressGivesTheDigestOfTheSimulation) {
  const Client client = client_of();
  Watcher watcher(client);
  const Json body = {{"experiment", "experiment.toml"}, {"duration_s", 5}, {"seed", 3}, {"pace", 0}, {"record", false}};
  ASSERT_EQ(client.post("/api/run/start", body).status, 200u);
  const Json here = final_state(watcher);
  Robot robot(folder() / "experiment.toml");
  Json there = body;
  there["address"] = robot.address();
  ASSERT_EQ(client.post("/api/run/start", there).status, 200u);
  const Json state = final_state(watcher);
  EXPECT_EQ(state["outcome"]["digest"], here["outcome"]["digest"]) << state.dump();
}

TEST_F(Link, ARobotThatGoesAwayEndsTheRunInWordsOfBothLanguages) {
  const Client client = client_of();
  Watcher watcher(client);
  Robot robot(folder() / "experiment.toml");
  const Json body = {{"experiment", "experiment.toml"}, {"pace", 1}, {"address", robot.address()}};
  ASSERT_EQ(client.post("/api/run/start", body).status, 200u);
  while (robot.recorder().orders().size() < 3) std::this_thread::yield();
  robot.stop();
  const Json outcome = final_state(watcher)["outcome"];
  EXPECT_FALSE(outcome["success"]);
  EXPECT_TRUE(outcome["reason"].get<std::string>().starts_with("link lost: ")) << outcome.dump();
  const std::string spanish = outcome["reason_es"];
  EXPECT_TRUE(spanish.starts_with("enlace perdido: ")) << spanish;
  EXPECT_EQ(spanish.find(" the "), std::string::npos) << spanish;
}

TEST_F(Link, WhenTheServerIsKilledTheRobotTakesItsSafeValuesWithinTheTimeToLive) {
  constexpr double kTick_s = 0.1, kTtl_s = 0.3;  // the controller names no other
  ChildServer server(folder());
  Robot robot(folder() / "experiment.toml");
  const Json body = {{"experiment", "experiment.toml"},
                     {"record", false},
                     {"address", robot.address()},
                     {"set", {"application.pace=free_running"}}};
  const Answer started = server.client().post("/api/run/start", body);
  ASSERT_EQ(started.status, 200u) << started.body;
  const auto commanded = [&] {
    const auto orders = robot.recorder().orders();
    return std::count_if(orders.begin(), orders.end(), [](const Order& one) { return one.commanded; });
  };
  while (commanded() < 10) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  server.kill();
  const double killed_s = link::steady_s();
  while (link::steady_s() < killed_s + 2) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  double last_s = 0;
  std::size_t after = 0;
  for (const Order& order : robot.recorder().orders()) {
    if (order.at_s > killed_s) ++after;
    if (order.commanded) last_s = order.at_s;
  }
  EXPECT_GT(after, 5u) << "the robot kept its own time";
  EXPECT_FALSE(robot.recorder().orders().back().commanded);
  // No tick begins with a command whose time is over; one tick more is for a busy machine.
  EXPECT_LT(last_s - killed_s, kTtl_s + kTick_s);
  std::printf("the last tick with a command began %.3f s after the kill; its time to live is %.1f s\n",
              last_s - killed_s, kTtl_s);
}

}  // namespace
}  // namespace ganglion::studio
