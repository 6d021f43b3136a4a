#include "ganglion/run/inputs.h"
#include "ganglion/run/controller_hash.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/graph/testing/rig.h"
#include "ganglion/record/recover.h"
#include "ganglion/run/replay.h"
#include "ganglion/run/run.h"

// What a run file holds of the files that a run read, and a run that is repeated from it alone.
namespace ganglion {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path kExperiments = fs::path(GANGLION_SOURCE_DIR) / "experiments";

/// After one tick with the reading 0.1 everywhere.
std::uint64_t digest_of(ControllerModel model) {
  const Description robot = testing::test_robot();
  Problems problems;
  resolve(model, robot, problems);
  EXPECT_EQ(problems.text(), "");
  auto controller = Controller::compile(model, robot, testing::kinds(), {}).value();
  SenseFrame sense = make_sense_frame(robot);
  ActFrame act = make_act_frame(robot);
  sense.values.assign(sense.values.size(), 0.1);
  controller.tick(sense, 0.1, act);
  return controller.digest().total();
}

class Inputs : public FolderTest {
 protected:
  void put(const std::string& name, std::string_view text) const { EXPECT_TRUE(write_file(folder_ / name, text)); }

  /// Runs the experiment for a second.
  RunResult run_once(const fs::path& experiment, std::vector<config::Override> overrides = {}) const {
    overrides.push_back({"run.duration_s", "1"});
    overrides.push_back({"run.free_ground", "false"});
    Problems problems;
    const auto prepared = prepare(experiment, overrides, problems);
    EXPECT_EQ(problems.text(), "");
    RunOptions options;
    options.run_file = file_;
    return run(prepared.value(), options).value();
  }
  void expect_the_same_again(const std::string& digest) const {
    const auto replayed = replay_run(file_);
    ASSERT_TRUE(replayed) << replayed.error().text();
    EXPECT_TRUE(replayed->same);
    EXPECT_EQ(replayed->digest, digest);
  }

  const fs::path file_ = folder_ / "run.mcap";
};

TEST_F(Inputs, AreAttachedOnceUnderTheirNames) {
  run_once(kExperiments / "pathfinder");
  const RunFile run = RunFile::read(file_).value();
  std::vector<std::string> names;
  for (const mcap::Attachment& one : run.attachments) names.push_back(one.name);
  const std::vector<std::string> right = {"experience",       "input/controller.toml", "input/experiment.toml",
                                          "input/robot.toml", "input/rooms.toml",      "inputs.json"};
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, right);
  const Json list = Json::parse(run.attachment("inputs.json")->bytes);
  EXPECT_EQ(list["controller"], "controller.toml") << "as in files of before";
  EXPECT_EQ(
      list["files"][1],
      Json({{"role", "controller"}, {"named", "controller.toml"}, {"attached", "input/controller.toml"}, {"by", 0}}));
}

TEST_F(Inputs, MakeARunRepeatableWhereNoneOfThemIsLeft) {
  fs::copy(kExperiments / "nimrod", folder_ / "here", fs::copy_options::recursive);
  put("here/maps/floor.yaml",
      "image: floor.pgm\nresolution: 1\norigin: [-20, -20, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n");
  put("here/maps/floor.pgm", "P5 60 60 255\n" + std::string(3600, '\xff'));
  put("here/world.toml", "format = 1\nmap = \"maps/floor.yaml\"\n");
  const std::string robot = (folder_ / "here/robot.toml").string();
  const RunResult result = run_once(folder_ / "here", {{"application.world", (folder_ / "here/world.toml").string()},
                                                       {"application.spawn.pose", "[0, 0, 0]"},
                                                       {"application.robot", robot}});
  fs::remove_all(folder_ / "here");
  expect_the_same_again(result.digest);
  const RunFile run = RunFile::read(file_).value();
  EXPECT_NE(run.attachment("input/maps/floor.pgm"), nullptr);
}

TEST_F(Inputs, MayStandBehindLinks) {
  fs::copy(kExperiments / "nimrod", folder_ / "here", fs::copy_options::recursive);
  fs::create_directories(folder_ / "there");
  fs::rename(folder_ / "here/controller.toml", folder_ / "there/brain.toml");
  fs::create_symlink(folder_ / "there/brain.toml", folder_ / "here/controller.toml");
  fs::copy_file(folder_ / "here/robot.toml", folder_ / "there/robot.toml");
  const RunResult result = run_once(folder_ / "here");
  fs::remove_all(folder_ / "here");
  fs::remove_all(folder_ / "there");
  expect_the_same_again(result.digest);
}

TEST_F(Inputs, OfFilesThatParametersNameAreFoundAgain) {
  put("c.toml",
      "format = 1\n[[sensing]]\nid = \"x\"\nkind = \"Ruled\"\nrules = \"rules.txt\"\nin.in = \"a\"\n"
      "[[sensing]]\nid = \"y\"\nkind = \"Ruled\"\nin.in = \"x.near\"\n[[sensation]]\nid = \"a\"\nchannel = \"a\"\n");
  put("rules.txt", "near 2\n");
  DiskFiles disk;
  Problems problems;
  Experiment experiment;
  experiment.opened.controller = disk.open("controller", (folder_ / "c.toml").string(), -1, 1000).value();
  const ControllerModel model = read_controller(config::parse(disk.at(0)).value(), testing::kinds(), problems, &disk);
  auto recorder = RunRecorder::create(file_, {});
  attach_inputs(*recorder, experiment, {disk.opened().begin(), disk.opened().end()});
  ASSERT_TRUE(recorder->finish({}));
  fs::remove(folder_ / "rules.txt");
  fs::remove(folder_ / "c.toml");

  const RunFile run = RunFile::read(file_).value();
  const auto attached = AttachedFiles::of(run).value();
  const int controller = attached->open("controller", "whatever", -1, 1000).value();
  const ControllerModel again =
      read_controller(config::parse(attached->at(controller)).value(), testing::kinds(), problems, attached.get());
  EXPECT_EQ(problems.text(), "");
  EXPECT_EQ(again.components[1].parameters.file("rules").text, "near 2\n");
  ASSERT_EQ(attached->opened().size(), 3u);
  EXPECT_EQ(attached->at(2).named, "builtin:twice.txt") << "as the program had it that made the run";
  EXPECT_EQ(controller_hash(attached->at(0), again, {}), controller_hash(disk.at(0), model, {}));
  EXPECT_EQ(digest_of(again), digest_of(model));
  EXPECT_EQ(attached->open("sensing.y.rules", "rules.txt", controller, 1000).value(), 3) << "found by its name";
  EXPECT_EQ(attached->open("any", "none.txt", controller, 1000).error().code, ErrorCode::NotFound);
  EXPECT_EQ(attached->open("any", "rules.txt", controller, 3).error().code, ErrorCode::TooLarge);
}

TEST_F(Inputs, CountInTheHashOfTheController) {
  put("c.toml", "format = 1\n[[sensing]]\nid = \"x\"\nkind = \"Ruled\"\nrules = \"rules.txt\"\nin.in = \"a\"\n");
  const auto hash = [&](std::string_view rules, const std::vector<config::Override>& overrides = {}) {
    put("rules.txt", rules);
    DiskFiles disk;
    Problems problems;
    const int file = disk.open("controller", (folder_ / "c.toml").string(), -1, 1000).value();
    const auto model = read_controller(config::parse(disk.at(file)).value(), testing::kinds(), problems, &disk);
    return controller_hash(disk.at(file), model, overrides);
  };
  const std::string first = hash("near 2\n");
  EXPECT_EQ(hash("near 2\n"), first);
  EXPECT_NE(hash("near 3\n"), first);
  EXPECT_NE(hash("near 2\n", {{"tick_s", "1"}}), first);
}

TEST_F(Inputs, OfARunFileWithoutAListCannotBeRead) {
  auto recorder = RunRecorder::create(file_, {});
  ASSERT_TRUE(recorder->finish({}));
  EXPECT_EQ(AttachedFiles::of(RunFile::read(file_).value()).error().code, ErrorCode::Corrupt);
}

TEST_F(Inputs, ThatAHostileListNamesLeadNowhere) {
  for (const char* list :
       {"[]", "{}", "{\"files\": 3}", "{\"files\": [3, {\"by\": \"x\"}, {\"role\": 1, \"by\": 9999999999}]}",
        "{\"experiment\": \"../../etc/passwd\", \"overrides\": [3, [1, 2]]}",
        "{\"files\": [{\"role\": \"experiment\", \"named\": \"/etc/passwd\", \"attached\": \"/etc/passwd\", \"by\": "
        "7}]}"}) {
    auto recorder = RunRecorder::create(file_, {});
    recorder->attach("inputs.json", list);
    ASSERT_TRUE(recorder->finish({}));
    EXPECT_FALSE(replay_run(file_)) << list;
  }
}

TEST_F(Inputs, AreReplayedWhereOnlyTheSummaryIsDamaged) {
  const RunResult result = run_once(kExperiments / "pathfinder");
  const std::string whole = read_file(file_).value();
  constexpr std::size_t kFooter = 9 + 20 + 8;                       // its head, its content, the magic bytes
  for (const std::size_t from_end : {kFooter - 9, kFooter + 20}) {  // where it says the summary begins; the summary
    std::string damaged = whole;
    damaged[whole.size() - from_end] = static_cast<char>(damaged[whole.size() - from_end] ^ 0x40);
    put("run.mcap", damaged);
    ASSERT_FALSE(RunFile::read(file_));
    expect_the_same_again(result.digest);
    EXPECT_EQ(replay_run(file_)->damages.size(), 1u);
  }
  std::string damaged = whole;
  damaged[whole.size() / 2] = static_cast<char>(damaged[whole.size() / 2] ^ 0x40);
  put("run.mcap", damaged);
  EXPECT_EQ(replay_run(file_).error().code, ErrorCode::Corrupt) << "of the data";
}

TEST_F(Inputs, OfARunThatWasCutAreRepeatedOrToldToBeLost) {
  run_once(kExperiments / "pathfinder");
  const std::string whole = read_file(file_).value();
  const fs::path saved = folder_ / "saved.mcap";
  std::size_t repeated = 0, lost = 0;
  for (std::size_t cut = 100; cut < whole.size(); cut += 499) {
    put("cut.mcap", whole.substr(0, cut));
    if (!recover_run(folder_ / "cut.mcap", saved)) continue;  // nothing of a run is left
    const auto replayed = replay_run(saved);
    EXPECT_EQ(replay_run(folder_ / "cut.mcap").has_value(), replayed.has_value()) << cut;
    EXPECT_TRUE(replayed ? replayed->same : replayed.error().code == ErrorCode::Corrupt) << cut;
    ++(replayed ? repeated : lost);
    if (replayed) continue;
    const std::string told = replayed.error().text();
    EXPECT_TRUE(told.find("lost what went into the run") != std::string::npos ||
                told.find("holds no list of its input files") != std::string::npos)
        << told;
  }
  EXPECT_GT(repeated, 0u);
  EXPECT_GT(lost, 0u);
}

}  // namespace
}  // namespace ganglion
