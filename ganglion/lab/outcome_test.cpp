#include "ganglion/lab/outcome.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "ganglion/base/file.h"

namespace ganglion::lab {
namespace {

using Json = nlohmann::ordered_json;

TEST(Outcome, IsTheSameAfterItsWayThroughJson) {
  Fault fault;
  fault.target = "compass";
  fault.kind = FaultKind::Biased;
  fault.amount = 0.35;
  fault.from_s = 5;
  Outcome outcome{.job = {.experiment = "here/experiment.toml",
                          .overrides = {{"run.duration_s", "60"}, {"controller.name", "a=b"}},
                          .seed = 9'000'000'000'000'000,
                          .episode = 2,
                          .faults = {fault}},
                  .verdict = Verdict::Failed,
                  .reason = {"stopped", "parada"},
                  .digest = "00112233445566ff",
                  .contacts = {.known = true, .count = 2, .fastest_mps = 0.1},
                  .figures = {{"way_m", 0.1 + 0.2}, {"settling_s", std::nan("")}},
                  .interventions = 1,
                  .files = {"a.mcap", "a.html"},
                  .troubles = {{Trouble::Of::Link,
                                {ErrorCode::LinkLost, say({"no answer", "no responde"}), {"robot.toml", 3, 4}, {}}}}};
  const Json json = outcome_json(outcome);
  const Outcome again = read_outcome(Json::parse(json.dump()), "it").value();
  EXPECT_EQ(outcome_json(again), json);
  EXPECT_EQ(again.job.seed, outcome.job.seed);
  EXPECT_EQ(again.job.overrides[1].value, "a=b");
  EXPECT_EQ(again.job.faults[0].text(), fault.text());
  EXPECT_TRUE(std::isinf(again.job.faults[0].to_s));
  EXPECT_EQ(again.figures[0].second, 0.1 + 0.2) << "to the bit";
  EXPECT_TRUE(std::isnan(again.figures[1].second));
  EXPECT_EQ(again.verdict, Verdict::Failed);
  EXPECT_EQ(again.reason.es, "parada");
  ASSERT_NE(again.trouble(Trouble::Of::Link), nullptr);
  EXPECT_EQ(again.trouble(Trouble::Of::Link)->text(), "robot.toml:3:4: no answer");
}

TEST(Outcome, SaysNullWhereNobodyJudgedOrKnows) {
  Outcome outcome;
  outcome.contacts.known = false;
  const Json json = outcome_json(outcome);
  EXPECT_TRUE(json["success"].is_null());
  EXPECT_TRUE(json["contacts"]["count"].is_null());
  const Outcome again = read_outcome(json, "it").value();
  EXPECT_EQ(again.verdict, Verdict::NotJudged);
  EXPECT_FALSE(again.contacts.known);
}

TEST(Outcome, OfOlderProgramsIsRead) {
  const Json batch = Json::parse(read_file(GANGLION_SOURCE_DIR "/tests/golden/kept/batch.json").value());
  for (const Json& run : batch["runs"]) {
    const Outcome outcome = read_outcome(run, "runs").value();
    EXPECT_EQ(outcome.job.seed, run["seed"].get<std::uint64_t>());
    EXPECT_EQ(outcome.digest, run["digest"]);
    EXPECT_EQ(outcome.figures.size(), run["measures"].size());
  }
}

TEST(Outcome, WithoutWhatItMustHaveIsRefused) {
  const auto refusal = [](const char* text) {
    const auto read = read_outcome(Json::parse(text), "runs[3]");
    return read ? "" : read.error().what.en;
  };
  EXPECT_EQ(refusal("3"), "runs[3] has no \"success\" and \"measures\"");
  EXPECT_EQ(refusal(R"({"success": "yes", "measures": {}})"), "runs[3] has no \"success\" and \"measures\"");
  EXPECT_EQ(refusal(R"({"success": true, "measures": {"way_m": "far"}})"), "runs[3].measures.way_m is no number");
  EXPECT_EQ(refusal(R"({"success": true, "measures": {}, "seed": -1, "set": [3, "x"], "files": 3, "faults": [{}, 1],
                        "contacts": 7, "episode": "e", "troubles": [1, {"of": 3, "line": 2.5}], "reason": []})"),
            "");
}

}  // namespace
}  // namespace ganglion::lab
