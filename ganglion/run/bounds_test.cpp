#include "ganglion/run/bounds.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/run/check_file.h"
#include "ganglion/run/run.h"

// Numbers that follow from several keys, each of them good by itself.
namespace ganglion {
namespace {

namespace fs = std::filesystem;

class Bounds : public FolderTest {
 protected:
  Bounds() {
    fs::copy(fs::path(GANGLION_SOURCE_DIR) / "experiments" / "nimrod", folder_ / "nimrod", fs::copy_options::recursive);
    put("robot.toml", "", "");
  }

  /// The lines that check says of an experiment on open ground, without the folder's name.
  std::string said(const std::string& application, const std::string& run, const std::string& controller = "",
                   const std::string& robot = "") {
    put("controller.toml", controller, "tick_s = 0.1\n");
    put("robot.toml", robot, "");
    EXPECT_TRUE(
        write_file(folder_ / "nimrod" / "experiment.toml",
                   "format = 1\ncontroller = \"controller.toml\"\n[application]\n" + application + "\n[run]\n" + run));
    Problems problems;
    check_file(folder_ / "nimrod", problems);
    expect_a_run_to_agree(problems);
    std::string text = problems.text();
    for (const Problems::Note& note : problems.notes()) text += note.text().en + "\n";
    const std::string folder = (folder_ / "nimrod").string() + "/";
    for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder))
      text.erase(at, folder.size());
    return text;
  }

 private:
  void expect_a_run_to_agree(const Problems& checked) const {
    Problems problems;
    const auto prepared = prepare(folder_ / "nimrod", {}, problems);
    bool runs = prepared.has_value();
    if (runs && !prepared->experiment.link.remote()) {
      runs = run(*prepared, {.seed = 1, .stop = [] { return true; }}).has_value();
    }
    EXPECT_EQ(runs, checked.empty()) << checked.text();
  }

  /// The shipped file with a line more on top, and one less.
  void put(const std::string& name, const std::string& line, const std::string& without) {
    std::string text = *read_file(fs::path(GANGLION_SOURCE_DIR) / "experiments" / "nimrod" / name);
    if (!without.empty() && !line.empty()) text.erase(text.find(without), without.size());
    const std::size_t at = text.find("format = 1\n") + 11;
    EXPECT_TRUE(write_file(folder_ / "nimrod" / name, text.insert(at, line)));
  }
};

TEST_F(Bounds, OfTicks) {
  EXPECT_EQ(said("", "duration_s = 1e6\n"), "");
  // 1e6 s / 1e-4 s = 1e10
  EXPECT_EQ(said("", "duration_s = 1e6\n", "tick_s = 1e-4\n"),
            "experiment.toml:6:14: 1000000 s in ticks of 0.0001 s are 10000000000 ticks; the limit is 2147483648\n");
  EXPECT_EQ(said("", "duration_s = 2147.483648\n", "tick_s = 1e-6\n"), "") << "2^31 ticks are just within";
  EXPECT_NE(said("", "duration_s = 2147.483650\n", "tick_s = 1e-6\n"), "");
}

TEST_F(Bounds, OfTheLengthOfATick) {
  EXPECT_NE(said("", "", "tick_s = 1e-300\n").find("tick_s is 1e-300, must be >= 1e-06, or 0"), std::string::npos);
  EXPECT_NE(said("", "", "tick_s = 9e-7\n").find("must be >= 1e-06"), std::string::npos);
  EXPECT_EQ(said("", "", "tick_s = 0\n"), "");
  EXPECT_EQ(said("", "", "tick_s = 1\n"), "");
  const std::string slow = said("", "", "tick_s = 100\n");
  EXPECT_NE(slow.find(":3:10: note: tick_s is 100 s: a robot drives so long on one look at its sensors"),
            std::string::npos)
      << slow;
}

TEST_F(Bounds, OfFramesOverALink) {
  // Nimrod has 8 channels of one value and one age each: 128 bytes a robot, 8,192 of them are 1 MiB.
  EXPECT_EQ(said("address = \"tcp://127.0.0.1:7007\"\nrobots = 8192", ""), "");
  std::string wide =
      "format = 1\nname = \"wide\"\n[body]\nlength_m = 0.2\nwidth_m = 0.2\n[[command]]\nname = \"drive\"\n"
      "elements = [\"left\", \"right\"]\n[[sensation]]\nname = \"scan\"\nelements = [";
  for (int n = 0; n < 1000; ++n) wide += fmt::format("\"e{}\", ", n);
  EXPECT_TRUE(write_file(folder_ / "nimrod" / "wide.toml", wide + "]\n"));
  EXPECT_TRUE(write_file(folder_ / "nimrod" / "lone.toml",
                         "format = 1\nrobot = \"wide.toml\"\n[[sensation]]\nid = \"scan\"\nchannel = \"scan\"\n"));
  const auto said_of = [&](int robots) {
    EXPECT_TRUE(write_file(folder_ / "nimrod" / "experiment.toml",
                           fmt::format("format = 1\ncontroller = \"lone.toml\"\n[application]\naddress = "
                                       "\"tcp://127.0.0.1:7007\"\nrobots = {}\n",
                                       robots)));
    Problems problems;
    check_file(folder_ / "nimrod", problems);
    return problems.text();
  };
  EXPECT_EQ(said_of(130), "") << "8 x 1001 x 130 = 1,041,040 bytes, below 1,048,576";
  EXPECT_NE(said_of(131).find("experiment.toml:5:10: a frame of 131 robots has 1049048 bytes; the limit of the link is "
                              "1048576"),
            std::string::npos)
      << said_of(131);
}

TEST_F(Bounds, OfTheRunOnOpenGround) {
  const std::string said_of = said("", "free_ground = true\nduration_s = 1e6\n", "tick_s = 0.001\n");
  EXPECT_NE(said_of.find("experiment.toml:6:15: the run on open ground keeps "), std::string::npos) << said_of;
}

TEST_F(Bounds, OfSubStepsOfATick) {
  EXPECT_EQ(said("robots = 10", "", "", "substep_s = 0.0001\n"), "") << "1,000 sub-steps for 10 robots";
  const std::string many = said("robots = 10", "", "tick_s = 1000\n", "substep_s = 0.01\n");
  EXPECT_EQ(many.find("TooLarge"), std::string::npos);
  EXPECT_EQ(many.find("sub-steps"), std::string::npos) << "100,000 for 10 robots are a million: " << many;
  const std::string more = said("robots = 11", "", "tick_s = 1000\n", "substep_s = 0.01\n");
  EXPECT_NE(
      more.find("robot.toml:4:13: a tick of 1000 s in sub-steps of at most 0.01 s are 1100000 for 11 robots; the limit "
                "is 1000000"),
      std::string::npos)
      << more;
}

TEST_F(Bounds, OfThePeriodOfASensor) {
  std::string text = *read_file(folder_ / "nimrod" / "robot.toml");
  const std::size_t at = text.find("[[sensor]]\n") + 11;
  EXPECT_TRUE(write_file(folder_ / "nimrod" / "robot.toml", text.insert(at, "period_s = 1e-300\n")));
  Problems problems;
  check_file(folder_ / "nimrod" / "robot.toml", problems);
  EXPECT_NE(problems.text().find("period_s is 1e-300, must be 0"), std::string::npos) << problems.text();
}

}  // namespace
}  // namespace ganglion
