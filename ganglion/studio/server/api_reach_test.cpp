#include "ganglion/studio/server/testing/bench.h"

// Goals set and obstacles put elsewhere in a run that is on.
namespace ganglion::studio {
namespace {

class Reaching : public ServerTest {
 protected:
  void SetUp() override {
    ServerTest::SetUp();
    std::filesystem::copy(GANGLION_SOURCE_DIR "/experiments/pathfinder", folder() / "pathfinder");
  }
  /// The pathfinder among crates that move, waiting before its first tick.
  static Json rooms(const char* more = "{}") {
    Json body = {{"experiment", "pathfinder/experiment.toml"},
                 {"world", "pathfinder/rooms_moving.toml"},
                 {"duration_s", 20},
                 {"paused", true},
                 {"pace", 0}};
    body.update(Json::parse(more));
    return body;
  }
  static std::string refusal(const Client& client, const char* path, const Json& body, unsigned status) {
    const Answer answer = client.post(path, body);
    EXPECT_EQ(answer.status, status) << answer.body;
    return answer.status == 200 ? "" : answer.json()["error"]["message"].get<std::string>();
  }
  static Json goal(double x_m, double y_m) { return {{"robot", 0}, {"x_m", x_m}, {"y_m", y_m}}; }
  static Json crate(double x_m, double y_m) { return {{"mover", "crate_1"}, {"x_m", x_m}, {"y_m", y_m}}; }
};

TEST_F(Reaching, SetsAGoalAndPutsAnObstacleWhileTheRunWaits) {
  const Client client = client_of();
  Watcher watcher(client);
  ASSERT_EQ(client.post("/api/run/start", rooms()).status, 200u);
  ASSERT_TRUE(watcher.event("streams"));
  const Json set = client.post("/api/run/goal", goal(2.3, 9.4)).json();
  EXPECT_EQ(set["x_m"], 2.25) << set.dump();
  EXPECT_EQ(set["y_m"], 9.25);
  EXPECT_EQ(set["reachable"], true);
  EXPECT_EQ(set["state"]["state"], "armed");
  const auto told = watcher.event("intervention");
  ASSERT_TRUE(told);
  EXPECT_EQ((*told)["what"], "goal");
  EXPECT_EQ((*told)["tick"], 0);
  EXPECT_EQ((*told)["x_m"], 2.3);
  Json last;
  while (last["name"] != "trainer" || last["message"].get<std::string>().find(": set") == std::string::npos) {
    last = watcher.event("log").value();
  }
  EXPECT_NE(last["message"].get<std::string>().find("cell 4, 18"), std::string::npos) << last;
  ASSERT_EQ(client.post("/api/run/step", {{"ticks", 3}}).status, 200u);
  while (client.get("/api/run").json()["share"] < 0.149) {
  }
  ASSERT_EQ(client.post("/api/run/obstacle", crate(10.25, 9.25)).status, 200u);
  const auto put = watcher.event("intervention");
  ASSERT_TRUE(put);
  EXPECT_EQ((*put)["what"], "obstacle");
  EXPECT_EQ((*put)["mover"], "crate_1");
  EXPECT_EQ((*put)["tick"], 3);
  EXPECT_EQ((*put)["time_s"], 3);
  std::string movers;
  while (movers.find(R"("x_m":10.25,"y_m":9.25)") == std::string::npos) {
    const auto message = watcher.next();
    ASSERT_TRUE(message) << "the sample of the movers never came";
    if (message->binary && message->bytes[0] == 4) movers = message->bytes.substr(16);
  }
  client.post("/api/run/resume", {});
  Json state;
  while (state["state"] != "done") state = watcher.event("run", 60).value()["state"];
  EXPECT_EQ(state["outcome"]["interventions"], 2);
  EXPECT_NE(state["outcome"]["reason"].get<std::string>().find("interventions: 2"), std::string::npos);
  const Json recording = client.post("/api/recording/open", {{"path", state["outcome"]["file"]}}).json();
  std::vector<Json> recorded;
  for (const Json& event : recording["events"]) {
    if (event["event"] == "intervention") recorded.push_back(event);
  }
  ASSERT_EQ(recorded.size(), 2u);
  EXPECT_EQ(recorded[1]["mover"], "crate_1");
  EXPECT_EQ(recorded[1]["time_s"], 3);
}

TEST_F(Reaching, AnswersAtOnceThoughTheNextTickIsFarOff) {
  const Client client = client_of();
  Watcher watcher(client);
  ASSERT_EQ(client.post("/api/run/start", rooms(R"({"pace":1e-6,"paused":false})")).status, 200u);
  ASSERT_TRUE(watcher.event("streams"));
  while (client.get("/api/run").json()["state"] != "running") {
  }
  EXPECT_EQ(client.post("/api/run/goal", goal(2.3, 9.4)).status, 200u);
}

TEST_F(Reaching, SaysWhyNot) {
  const Client client = client_of();
  Watcher watcher(client);
  EXPECT_EQ(refusal(client, "/api/run/goal", goal(2, 9), 409), "no run is on");
  ASSERT_EQ(client.post("/api/run/start", rooms()).status, 200u);
  ASSERT_TRUE(watcher.event("streams"));
  while (client.get("/api/run").json()["state"] != "armed") {
  }
  EXPECT_EQ(refusal(client, "/api/run/goal", goal(4.25, 9), 400),
            "cell (8, 18) at (4.25, 9.25) cannot be a goal: there is no room for the robot at its centre");
  Json spanish = crate(4.25, 9);
  spanish["language"] = "es";
  EXPECT_EQ(refusal(client, "/api/run/obstacle", spanish, 400),
            "\"crate_1\" no puede estar en (4.25, 9.00): hay una pared o algo sólido");
  EXPECT_NE(refusal(client, "/api/run/obstacle", {{"mover", "crate"}, {"x_m", 1}, {"y_m", 1}}, 404).find("crate_1"),
            std::string::npos);
  EXPECT_EQ(refusal(client, "/api/run/goal", {{"robot", 7}, {"x_m", 1}, {"y_m", 1}}, 404),
            "there is no robot 7: they are numbered from 0 to 0");
  EXPECT_EQ(refusal(client, "/api/run/goal", {{"robot", 0.5}, {"x_m", 1}, {"y_m", 1}}, 400),
            "robot must be a whole number from 0 on");
  EXPECT_EQ(refusal(client, "/api/run/goal", {{"robot", 0}, {"x_m", "1"}}, 400), "x_m and y_m must be numbers");
  client.post("/api/run/resume", {});
  Json state;
  while (state["state"] != "done") state = watcher.event("run", 60).value()["state"];
  EXPECT_EQ(state["outcome"]["interventions"], 0);
  EXPECT_EQ(refusal(client, "/api/run/obstacle", crate(10.25, 9.25), 409), "no run is on");
}

TEST_F(Reaching, RefusesWhereTheRobotHasNoSuchTaskOrIsNotOurs) {
  const Client client = client_of();
  Watcher watcher(client);
  const Json nimrod = {{"experiment", "experiment.toml"}, {"paused", true}, {"record", false}};
  ASSERT_EQ(client.post("/api/run/start", nimrod).status, 200u);
  while (client.get("/api/run").json()["state"] != "armed") {
  }
  EXPECT_EQ(refusal(client, "/api/run/goal", goal(1, 1), 400), "\"goal\" cannot be done to Nimrod");
  client.post("/api/run/stop", {});
  server().attach(std::make_shared<LiveFeed>(), {{"state", "running"}});
  EXPECT_EQ(refusal(client, "/api/run/goal", goal(1, 1), 403),
            "this run belongs to the command line; it can only be watched");
  EXPECT_EQ(refusal(client, "/api/run/obstacle", crate(1, 1), 403),
            "this run belongs to the command line; it can only be watched");
}

}  // namespace
}  // namespace ganglion::studio
