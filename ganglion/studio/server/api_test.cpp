#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <thread>

#include "ganglion/base/file.h"
#include "ganglion/record/run_file.h"
#include "ganglion/run/run.h"
#include "ganglion/studio/server/testing/bench.h"
#include "ganglion/studio/server/testing/child_server.h"

namespace ganglion::studio {
namespace {

using Studio = ServerTest;

template <class T>
T at(const std::string& bytes, std::size_t offset) {
  T value{};
  if (offset + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

Json short_run(const char* more = "{}") {
  Json body = {{"experiment", "experiment.toml"}, {"duration_s", 5}, {"seed", 3}, {"pace", 0}, {"record", false}};
  body.update(Json::parse(more));
  return body;
}

/// The state that a viewer is told at last.
Json final_state(Watcher& watcher) {
  while (auto event = watcher.event("run", 60)) {
    if ((*event)["state"]["state"] == "done") return (*event)["state"];
  }
  return {};
}

TEST_F(Studio, ListsAControllerThatWasOnlyBegun) {
  const Client client = client_of();
  const Json begun = {{"path", "mine.toml"}, {"text", "format = 1\nname = \"Mine\"\nrobot = \"robot.toml\"\n"}};
  Json saved = begun, draft = begun;
  saved["based_on"] = "";
  const Answer answer = client.post("/api/file/save", saved);
  ASSERT_EQ(answer.status, 200u) << answer.body;
  draft["based_on"] = answer.json()["hash"];
  ASSERT_EQ(client.post("/api/file/autosave", draft).status, 200u);
  const Json controllers = client.get("/api/files").json()["controllers"];
  const auto mine =
      std::find_if(controllers.begin(), controllers.end(), [](const Json& one) { return one["path"] == "mine.toml"; });
  ASSERT_NE(mine, controllers.end());
  EXPECT_EQ((*mine)["draft"], true);
}

TEST_F(Studio, ListsWhatTheFolderHolds) {
  const Json files = client_of().get("/api/files").json();
  EXPECT_EQ(files["controllers"].size(), 3u);
  EXPECT_EQ(files["experiments"].size(), 2u);
  EXPECT_EQ(files["robots"][0]["path"], "robot.toml");
  EXPECT_EQ(files["worlds"].size(), 2u);
  EXPECT_EQ(files["experiments"][1]["controller"], "controller.toml");
  EXPECT_EQ(files["experiments"][1]["duration_s"], 120);
}

TEST_F(Studio, TellsTheKindsOfControllerComponents) {
  const Json kinds = client_of().get("/api/kinds").json();
  ASSERT_GT(kinds.size(), 5u);
  for (const Json& kind : kinds) EXPECT_NE(kind["class"], "sensor");
}

TEST_F(Studio, SavesWhatItOpenedAndNothingElse) {
  const Client client = client_of();
  const Json opened = client.post("/api/file/open", {{"path", "controller.toml"}}).json();
  const std::string text = opened["text"].get<std::string>() + "# mine\n";
  ASSERT_TRUE(write_file(folder() / "controller.toml", "# changed outside\n"));
  const Answer conflict =
      client.post("/api/file/save", {{"path", "controller.toml"}, {"text", text}, {"based_on", opened["hash"]}});
  EXPECT_EQ(conflict.status, 409u);
  EXPECT_EQ(conflict.json()["error"]["arguments"]["text"], "# changed outside\n");
  EXPECT_EQ(read_file(folder() / "controller.toml").value(), "# changed outside\n") << "nothing was overwritten";
  const Json now = conflict.json()["error"]["arguments"];
  EXPECT_EQ(
      client.post("/api/file/save", {{"path", "controller.toml"}, {"text", text}, {"based_on", now["hash"]}}).status,
      200u);
  EXPECT_EQ(read_file(folder() / "controller.toml").value(), text);
  EXPECT_EQ(client.post("/api/file/save", {{"path", "controller.toml"}, {"text", text}, {"based_on", ""}}).status, 409u)
      << "a new file must be new";
  EXPECT_EQ(client.post("/api/file/save", {{"path", "x.sh"}, {"text", text}, {"based_on", ""}}).status, 400u);
}

TEST_F(Studio, NoticesAChangeFromOutside) {
  const Client client = client_of();
  Watcher watcher(client);
  ASSERT_EQ(client.post("/api/file/open", {{"path", "controller.toml"}}).status, 200u);
  ASSERT_TRUE(write_file(folder() / "controller.toml", "# other\n"));
  const auto event = watcher.event("file", 10);
  ASSERT_TRUE(event);
  EXPECT_EQ((*event)["path"], "controller.toml");
  EXPECT_EQ((*event)["hash"], client.post("/api/file/open", {{"path", "controller.toml"}}).json()["hash"]);
}

TEST_F(Studio, LosesNothingThatWasSavedOrAutosavedWhenItIsKilled) {
  ChildServer killed(folder());  // at any moment
  const Client& client = killed.client();
  const Json opened = client.post("/api/file/open", {{"path", "controller.toml"}}).json();
  std::atomic<int> kept = -1;
  std::thread editing([&] {
    for (int i = 0; i < 100'000; ++i) {
      const Json draft = {{"path", "controller.toml"},
                          {"text", "# edit " + std::to_string(i) + "\n" + std::string(20'000, '#')},
                          {"based_on", opened["hash"]}};
      if (client.post("/api/file/autosave", draft).status != 200) return;
      kept = i;
    }
  });
  while (kept < 50) std::this_thread::yield();
  killed.kill();
  editing.join();
  const Json again = client_of().post("/api/file/open", {{"path", "controller.toml"}}).json();
  EXPECT_EQ(again["text"], opened["text"]) << "the file itself is as it was saved";
  ASSERT_TRUE(again["draft"].is_object());
  EXPECT_EQ(again["draft"]["based_on"], opened["hash"]);
  const std::string draft = again["draft"]["text"];
  EXPECT_EQ(draft.size(), draft.find('\n') + 1 + 20'000) << "whole";
  EXPECT_GE(std::stoi(draft.substr(7)), kept.load());
}

TEST_F(Studio, EditsADocumentAndChecksIt) {
  const Client client = client_of();
  const std::string text = client.post("/api/file/open", {{"path", "controller.toml"}}).json()["text"];
  const Json edited =
      client
          .post("/api/document/edit", {{"path", "controller.toml"},
                                       {"text", text},
                                       {"operations", {{{"op", "rename"}, {"id", "escape"}, {"to", "flee"}}}}})
          .json();
  EXPECT_TRUE(edited["model"]["runnable"]) << edited.dump();
  EXPECT_EQ(edited["ids"], Json::parse("[\"flee\"]"));
  const Json why = client
                       .post("/api/document/may_connect", {{"path", "controller.toml"},
                                                           {"text", text},
                                                           {"from", "sonar_left"},
                                                           {"to", "hold"},
                                                           {"port", "heading"}})
                       .json();
  EXPECT_FALSE(why["ok"]);
  EXPECT_EQ(why["reasons"].size(), 1u);
}

TEST_F(Studio, RunsAndTellsEveryViewerTheSame) {
  const Client client = client_of();
  std::vector<std::unique_ptr<Watcher>> viewers;
  for (int i = 0; i < 3; ++i) viewers.push_back(std::make_unique<Watcher>(client));
  ASSERT_EQ(client.post("/api/run/start", short_run()).status, 200u);
  std::vector<Json> states;
  for (auto& viewer : viewers) states.push_back(final_state(*viewer));
  EXPECT_EQ(states[0], states[1]);
  EXPECT_EQ(states[0], states[2]);
  EXPECT_EQ(states[0]["outcome"]["digest"].get<std::string>().size(), 16u);
}

TEST_F(Studio, ARunThatIsWatchedGivesTheDigestOfOneThatIsNot) {
  Problems problems;
  const auto prepared = prepare(folder() / "experiment.toml", {{"run.duration_s", "5"}}, problems);
  ASSERT_TRUE(prepared);
  const auto alone = run(*prepared, {.seed = 3});
  ASSERT_TRUE(alone);
  const Client client = client_of();
  std::vector<std::unique_ptr<Watcher>> viewers;
  for (int i = 0; i < 10; ++i) viewers.push_back(std::make_unique<Watcher>(client));
  client.post("/api/run/start", short_run());
  EXPECT_EQ(final_state(*viewers[7])["outcome"]["digest"], alone->digest);
}

TEST_F(Studio, IsArmedBeforeTheFirstTickAndStepsOneTickAtATime) {
  const Client client = client_of();
  Watcher watcher(client);
  ASSERT_EQ(client.post("/api/run/start", short_run(R"({"paused":true})")).status, 200u);
  const auto streams = watcher.event("streams");
  ASSERT_TRUE(streams);
  EXPECT_EQ((*streams)["streams"][0]["topic"], "/robot0/signals");
  EXPECT_EQ((*streams)["streams"][0]["columns"][0]["name"], "truth.x_m");
  EXPECT_TRUE((*streams)["scene"].is_object());
  ASSERT_EQ(client.post("/api/run/step", {{"ticks", 3}}).status, 200u);
  std::vector<std::uint32_t> ticks;
  while (ticks.size() < 3) {
    const auto message = watcher.next();
    ASSERT_TRUE(message);
    if (message->binary && message->bytes[0] == 1) ticks.push_back(at<std::uint32_t>(message->bytes, 16));
  }
  EXPECT_EQ(ticks, (std::vector<std::uint32_t>{0, 1, 2}));
  Json state;
  while ((state = client.get("/api/run").json())["share"] < 0.0599) {  // the third tick is told before it is over
  }
  EXPECT_NEAR(state["time_s"].get<double>(), 0.3, 1e-9);
  EXPECT_EQ(client.post("/api/run/start", short_run()).status, 409u) << "one run at a time";
  ASSERT_EQ(client.post("/api/run/resume", {}).status, 200u);
  EXPECT_TRUE(final_state(watcher)["outcome"].is_object());
  EXPECT_EQ(client.post("/api/run/pause", {}).status, 409u);
}

TEST_F(Studio, SendsRowsAsTheRunHasThem) {
  const Client client = client_of();
  Watcher watcher(client);
  client.post("/api/run/start", short_run(R"({"paused":true})"));
  const auto streams = watcher.event("streams");
  ASSERT_TRUE(streams);
  const std::size_t columns = (*streams)["streams"][0]["columns"].size();
  client.post("/api/run/step", {});
  std::optional<Watcher::Message> row;
  while ((row = watcher.next()) && !row->binary) {
  }
  ASSERT_TRUE(row);
  EXPECT_EQ(row->bytes.size(), 16 + 8 + 8 * columns);
  EXPECT_EQ(at<std::uint8_t>(row->bytes, 1), 1);
  EXPECT_EQ(at<std::uint16_t>(row->bytes, 2), 1);
  EXPECT_EQ(at<std::uint32_t>(row->bytes, 4), 1u);
  EXPECT_EQ(at<double>(row->bytes, 8), 0.0);
  EXPECT_EQ(at<std::uint32_t>(row->bytes, 20), columns);
  EXPECT_TRUE(std::isfinite(at<double>(row->bytes, 24)));
}

TEST_F(Studio, StopsAndResets) {
  const Client client = client_of();
  Watcher watcher(client);
  client.post("/api/run/start", short_run(R"({"paused":true})"));
  client.post("/api/run/stop", {});
  EXPECT_TRUE(final_state(watcher)["outcome"]["reason"].get<std::string>().starts_with("interrupted"));
  ASSERT_EQ(client.post("/api/run/pace", {{"pace", 50}}).status, 200u);
  const Answer reset = client.post("/api/run/reset", {});
  ASSERT_EQ(reset.status, 200u);
  EXPECT_EQ(reset.json()["state"]["pace"], 50) << "as was chosen between the two";
  client.post("/api/run/resume", {});
  Json state = final_state(watcher);
  while (state.is_object() && state["run"] != reset.json()["run"]) state = final_state(watcher);  // told twice
  EXPECT_EQ(state["share"], 1.0);
}

TEST_F(Studio, RunsWhatIsDrawnWithoutSavingIt) {
  const Client client = client_of();
  const std::string saved = read_file(folder() / "controller.toml").value();
  Watcher watcher(client);
  Json body = short_run();
  body["controller"] = {{"path", "controller.toml"},
                        {"text", "format = 1\n[[acting]]\nid = \"a\"\nkind = \"Nothing\"\n"}};
  const Answer refused = client.post("/api/run/start", body);
  EXPECT_EQ(refused.status, 400u);
  EXPECT_FALSE(refused.json()["error"]["arguments"]["problems"].empty());
  std::string text = saved;
  text.replace(text.find("trigger_range_m = 0.10"), 22, "trigger_range_m = 0.20");
  body["controller"]["text"] = text;
  ASSERT_EQ(client.post("/api/run/start", body).status, 200u);
  const Json first = final_state(watcher)["outcome"];
  EXPECT_EQ(read_file(folder() / "controller.toml").value(), saved);
  const Answer again = client.post("/api/run/reset", {});
  ASSERT_EQ(again.status, 200u) << "the same drawing again";
  Json state;
  while ((state = final_state(watcher)).is_object() && state["run"] != again.json()["run"]) {
  }
  EXPECT_EQ(state["outcome"]["digest"], first["digest"]);
  body["record"] = true;
  const Answer third = client.post("/api/run/start", body);
  while ((state = final_state(watcher)).is_object() && state["run"] != third.json()["run"]) {
  }
  EXPECT_TRUE(state["outcome"]["error"].is_null()) << state.dump();
  const RunFile run = RunFile::read(folder() / state["outcome"]["file"].get<std::string>()).value();
  ASSERT_NE(run.attachment("input/controller.toml"), nullptr);
  EXPECT_EQ(run.attachment("input/controller.toml")->bytes, text) << "what was drawn, not what is saved";
  for (const auto& entry : std::filesystem::directory_iterator(folder()))
    EXPECT_FALSE(entry.path().filename().string().starts_with('.')) << entry.path();
}

TEST_F(Studio, GoesOnForAViewerWhoComesBack) {
  const Client client = client_of();
  std::string session;
  std::uint64_t seen = 0;
  {
    Watcher first(client);
    const Json hello = first.next()->json();
    session = hello["session"];
    seen = hello["seq"];
  }
  client.post("/api/file/save", {{"path", "a.toml"}, {"text", ""}, {"based_on", ""}});
  client.post("/api/file/save", {{"path", "b.toml"}, {"text", ""}, {"based_on", ""}});
  Watcher back(client, "/ws?session=" + session + "&after=" + std::to_string(seen));
  EXPECT_TRUE(back.next()->json()["resumed"]);
  const Json one = back.next()->json(), two = back.next()->json();
  EXPECT_EQ(one["seq"], seen + 1);
  EXPECT_EQ(one["path"], "a.toml");
  EXPECT_EQ(two["path"], "b.toml");
  Watcher stranger(client, "/ws?session=other&after=0");
  EXPECT_FALSE(stranger.next()->json()["resumed"]);
}

TEST_F(Studio, ReplaysARecordedRunAsItWasSeenLive) {
  const Client client = client_of();
  Watcher watcher(client);
  client.post("/api/run/start", short_run(R"({"record":true,"paused":true})"));
  ASSERT_TRUE(watcher.event("streams"));
  client.post("/api/run/step", {});
  std::optional<Watcher::Message> live;
  while ((live = watcher.next()) && !(live->binary && live->bytes[0] == 1)) {
  }
  ASSERT_TRUE(live);
  client.post("/api/run/resume", {});
  const Json outcome = final_state(watcher)["outcome"];
  const std::string file = outcome["file"];
  ASSERT_FALSE(file.empty());
  EXPECT_TRUE(outcome["error"].is_null()) << outcome.dump();
  const Json opened = client.post("/api/recording/open", {{"path", file}}).json();
  EXPECT_EQ(opened["run"]["digest"], outcome["digest"]);
  EXPECT_EQ(opened["streams"][0]["columns"][0]["name"], "truth.x_m");
  EXPECT_NEAR(opened["duration_s"].get<double>(), 4.9, 1e-9);
  const Answer samples = client.post("/api/recording/samples", {{"path", file}, {"to_s", 0}});
  EXPECT_EQ(samples.header("content-type"), "application/octet-stream");
  const auto size = at<std::uint32_t>(samples.body, 0);
  EXPECT_EQ(samples.body.substr(4, size), live->bytes) << "bit for bit what the viewer saw";
  EXPECT_NE(client.post("/api/recording/controller", {{"path", file}}).json()["text"].get<std::string>().find("Nimrod"),
            std::string::npos);
  const Answer report = client.get("/api/recording/report?path=" + file);
  EXPECT_TRUE(report.header("content-security-policy").starts_with("sandbox allow-scripts"));
  EXPECT_TRUE(report.header("content-type").starts_with("text/html"));
  EXPECT_EQ(client.get("/api/files").json()["runs"].size(), 1u);
}

TEST_F(Studio, LetsOthersOnlyWatchARunThatIsNotItsOwn) {
  const Client client = client_of();
  server().attach(std::make_shared<LiveFeed>(), {{"state", "running"}});
  EXPECT_EQ(client.post("/api/run/stop", {}).status, 403u);
  EXPECT_EQ(client.post("/api/run/start", short_run()).status, 403u);
  EXPECT_TRUE(client.get("/api/run").json()["attached"]);
}

}  // namespace
}  // namespace ganglion::studio
