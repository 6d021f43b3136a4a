#include "ganglion/run/interference.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "ganglion/link/net/server.h"
#include "ganglion/link/net/testing/serving.h"
#include "ganglion/link/robot/robot_end.h"
#include "ganglion/run/replay.h"
#include "ganglion/run/run_robots.h"

// Somebody reaches into the world of a run: sets goals, puts obstacles elsewhere.
namespace ganglion {
namespace {

namespace fs = std::filesystem;

const fs::path kPathfinder = fs::path(GANGLION_SOURCE_DIR) / "experiments" / "pathfinder";

/// The pathfinder among crates that move, for 60 ticks of 1 s.
Prepared prepared(const std::vector<config::Override>& more = {}) {
  std::vector<config::Override> overrides = {
      {"run.duration_s", "60"}, {"application.world", "\"" + (kPathfinder / "rooms_moving.toml").string() + "\""}};
  overrides.insert(overrides.end(), more.begin(), more.end());
  Problems problems;
  auto made = prepare(kPathfinder, overrides, problems);
  EXPECT_EQ(problems.text(), "");
  return made.value();
}

Intervention set_goal(int robot, Vector2 point) { return {"goal", robot, "", {{"x_m", point.x}, {"y_m", point.y}}}; }
Intervention put_mover(const std::string& mover, Vector2 point) {
  return {"obstacle", 0, mover, {{"x_m", point.x}, {"y_m", point.y}}};
}

RunResult result_of(const Prepared& prepared, const RunOptions& options) {
  auto result = run(prepared, options);
  EXPECT_TRUE(result) << result.error().text();
  return result ? *result : RunResult{};
}

const std::vector<TimedIntervention> kPlan = {
    {0, set_goal(0, {2.3, 9.4})}, {12, put_mover("crate_1", {10.25, 9.25})}, {20, set_goal(0, {0.8, 8.2})}};

class ATouchedRun : public ::testing::Test {
 protected:
  ATouchedRun() : file_(fs::temp_directory_path() / ("touched_" + std::to_string(::getpid()) + ".mcap")) {}
  ~ATouchedRun() override { fs::remove(file_); }
  RunFile recorded() const {
    auto file = RunFile::read(file_);
    EXPECT_TRUE(file) << file.error().text();
    return *file;
  }
  fs::path file_;
};

TEST_F(ATouchedRun, HasItsOwnDigestTheSameForTheSameTouches) {
  const Prepared rooms = prepared();
  const RunResult first = result_of(rooms, {.interventions = kPlan}),
                  again = result_of(rooms, {.interventions = kPlan});
  EXPECT_EQ(first.digest, again.digest);
  EXPECT_EQ(first.component_digests, again.component_digests);
  EXPECT_EQ(first.interventions, 3u);
  EXPECT_NE(first.reason.en.find("; interventions: 3"), std::string::npos) << first.reason.en;
  EXPECT_NE(first.reason.es.find("; intervenciones: 3"), std::string::npos) << first.reason.es;
  EXPECT_GE(measure(first.measures, "goals_reached"), 1) << "the one set before the first tick is four cells off";
  EXPECT_EQ(measure(first.measures, "goals_replaced"), 2) << "the trainer's first, and its next, open at 20 s";
  auto later = kPlan;
  later[1].tick = 13;
  EXPECT_NE(result_of(rooms, {.interventions = later}).digest, first.digest);
}

// As in tests/golden: what the program did on a day that is kept. To change only where a change of behaviour is meant.
TEST_F(ATouchedRun, HasTheDigestsThatAreKept) {
  const std::array<std::string, 5> kept = {"92928960cce89b6a", "71d89ac447263945", "aa70685b68a3096c",
                                           "512349925630b1a2", "2ba7ee9c7352cee3"};
  const Prepared rooms = prepared();
  for (std::size_t i = 0; i < kept.size(); ++i) {
    EXPECT_EQ(result_of(rooms, {.seed = i + 1, .interventions = kPlan}).digest, kept[i]) << "seed " << i + 1;
  }
}

TEST_F(ATouchedRun, IsNotTakenForTheSeedsOwnEvenWhereNothingCameOfIt) {
  const Prepared rooms = prepared();
  const RunResult alone = result_of(rooms, {});
  RunOptions options;
  Reach reach;
  options.reach = [&](Reach given) { reach = std::move(given); };
  EXPECT_EQ(result_of(rooms, options).digest, alone.digest) << "who could reach in and did not leaves it alone";
  EXPECT_EQ(alone.interventions, 0u);
  options.progress = [&](double share) {
    if (share == 1) {  // after the last tick
      EXPECT_TRUE(reach(put_mover("crate_8", {3.25, 5.75})));
    }
    return true;
  };
  const RunResult touched = result_of(rooms, options);
  EXPECT_NE(touched.digest, alone.digest);
  EXPECT_EQ(touched.component_digests.size(), alone.component_digests.size() + 1);
}

TEST_F(ATouchedRun, GivesTheSameWhetherPlannedOrDoneMeanwhile) {
  const Prepared rooms = prepared();
  RunOptions options;
  Reach reach;
  std::uint32_t ticks = 0;
  std::size_t next = 0;
  const auto act = [&] {
    for (; next < kPlan.size() && kPlan[next].tick == ticks; ++next) EXPECT_TRUE(reach(kPlan[next].what));
    return true;
  };
  options.reach = [&](Reach given) { reach = std::move(given); };
  options.armed = act;
  options.progress = [&](double) { return ++ticks, act(); };
  EXPECT_EQ(result_of(rooms, options).digest, result_of(rooms, {.interventions = kPlan}).digest);
}

TEST_F(ATouchedRun, RecordsWhatWasDoneAndWhenAndIsRepeatedBitForBit) {
  const RunResult result = result_of(prepared(), {.run_file = file_, .interventions = kPlan});
  const RunFile file = recorded();
  ASSERT_TRUE(file.outcome);
  EXPECT_EQ(file.outcome->interventions, 3u);
  const auto list = interventions_of(file);
  ASSERT_TRUE(list);
  ASSERT_EQ(list->size(), 3u);
  EXPECT_EQ((*list)[1].tick, 12u);
  EXPECT_EQ((*list)[1].what.name, "obstacle");
  EXPECT_EQ((*list)[1].what.subject, "crate_1");
  EXPECT_EQ((*list)[1].what.argument("x_m"), 10.25);
  EXPECT_EQ((*list)[1].what.argument("y_m"), 9.25);
  EXPECT_EQ((*list)[2].what.name, "goal");
  EXPECT_EQ((*list)[2].what.argument("x_m"), 0.8);
  const auto& log = file.json.at("/log").messages;
  EXPECT_TRUE(std::any_of(log.begin(), log.end(), [](const JsonMessage& message) {
    return message.text.find(R"("message_es":"\"crate_1\" puesto en (10.25, 9.25))") != std::string::npos;
  }));
  const auto& movers = file.json.at("/movers").messages;
  EXPECT_TRUE(std::any_of(movers.begin(), movers.end(), [](const JsonMessage& message) {
    return message.time_s == 12 && message.text.find(R"({"id":"crate_1","x_m":10.25,"y_m":9.25)") != std::string::npos;
  }));
  const auto& goals = file.json.at("/robot0/goals").messages;
  EXPECT_NE(goals[0].text.find("replaced"), std::string::npos) << goals[0].text;
  EXPECT_NE(goals[1].text.find(R"("x_m":2.25,"y_m":9.25,"state":"set")"), std::string::npos) << goals[1].text;
  const auto replayed = replay_run(file_);
  ASSERT_TRUE(replayed) << replayed.error().text();
  EXPECT_TRUE(replayed->same) << replayed->signal;
  EXPECT_EQ(replayed->digest, result.digest);
}

TEST_F(ATouchedRun, IsRepeatedAsFarAsItWentWhenItWasCutShort) {
  RunOptions options{.run_file = file_};
  Reach reach;
  std::uint32_t ticks = 0;
  options.reach = [&](Reach given) { reach = std::move(given); };
  options.progress = [&](double) {
    if (++ticks == 15) {
      EXPECT_TRUE(reach(set_goal(0, {0.8, 8.2})));
    }
    return ticks < 15;
  };
  const RunResult result = result_of(prepared(), options);
  const auto replayed = replay_run(file_);
  ASSERT_TRUE(replayed) << replayed.error().text();
  EXPECT_TRUE(replayed->same);
  EXPECT_EQ(replayed->digest, result.digest);
}

TEST_F(ATouchedRun, FailsWhereWhatWasPlannedCannotBe) {
  const auto failed = run(prepared(), {.interventions = {{5, put_mover("crate_1", {4.25, 9})}}});
  ASSERT_FALSE(failed);
  EXPECT_EQ(
      failed.error().what.en,
      "what was to be done before tick 5 cannot be: \"crate_1\" cannot stand at (4.25, 9.00): a wall or something "
      "solid is there");
}

TEST_F(ATouchedRun, RefusesWhereTheRobotsAreAtTheOtherEndOfALink) {
  const Prepared here = prepared();
  const auto application = here.application->make().value();
  ASSERT_TRUE(application->reset(1, 0));
  link::RobotEndConfig config;
  config.token = link::random_token;
  link::RobotEnd end(*application, config);
  const link::Serving serving(end);
  const std::string address = "\"" + serving.address().text + "\"";
  RunOptions options;
  std::string said;
  options.reach = [&](const Reach& reach) {
    const auto done = reach(set_goal(0, {2.3, 9.4}));
    said = done ? "" : done.error().what.en;
  };
  const RunResult result = result_of(prepared({{"application.address", address}, {"run.duration_s", "3"}}), options);
  EXPECT_TRUE(said.starts_with("the robots are at the other end of a link")) << said;
  EXPECT_EQ(result.interventions, 0u);
}

TEST(InterventionsOf, RefusesWhatItCannotMakeOut) {
  const auto read = [](std::vector<JsonMessage> messages) {
    RunFile file;
    file.json[std::string(kInterventionTopic)].messages = std::move(messages);
    const auto list = interventions_of(file);
    return list ? std::string() : list.error().what.en;
  };
  constexpr InterventionDescriptor kGoal{"goal", {"a goal", "un objetivo"}, "", {}, 0, {"a", "a"}};
  constexpr InterventionDescriptor kObstacle{"obstacle", {"an obstacle", "un obstáculo"}, "mover", {}, 1, {"a", "a"}};
  const std::string good = intervention_json(kGoal, {7, set_goal(1, {0.1, 1e-9})});
  EXPECT_EQ(good, R"({"tick":7,"what":"goal","robot":1,"x_m":0.1,"y_m":1e-09})");
  EXPECT_EQ(read({{7, good}}), "");
  EXPECT_EQ(read({{7, good}, {6.5, intervention_json(kObstacle, {6, put_mover("a", {})})}}),
            "the run file's intervention 2 at 6.5 s cannot be made out");
  for (const char* bad :
       {"", "[]", "{}", R"({"tick":1,"what":"goal","robot":-1,"x_m":0,"y_m":0})",
        R"({"tick":1,"what":"goal","robot":0,"x_m":"0","y_m":0})",
        R"({"tick":-1,"what":"obstacle","mover":"a","x_m":0,"y_m":0})",
        R"({"tick":1,"what":"obstacle","mover":3,"x_m":0,"y_m":0})", R"({"tick":1,"what":"door","x_m":0,"y_m":0})"}) {
    EXPECT_NE(read({{0, bad}}), "") << bad;
  }
}

}  // namespace
}  // namespace ganglion
