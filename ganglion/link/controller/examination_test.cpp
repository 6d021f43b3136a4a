#include "ganglion/link/controller/examination.h"

#include <gtest/gtest.h>

#include "ganglion/link/testing/bench.h"

namespace ganglion::link {
namespace {

/// A robot whose clock is another one's, spoilt.
class Spoilt final : public Application {
 public:
  using Clock = double (*)(double);
  Spoilt(Application& inner, Clock clock) : inner_(inner), clock_(clock) {}
  const Description& description() const noexcept override { return inner_.description(); }
  int robots() const noexcept override { return inner_.robots(); }
  Result<void> reset(std::uint64_t seed, std::uint32_t episode) override { return inner_.reset(seed, episode); }
  void sense(std::span<SenseFrame> frames) noexcept override {
    inner_.sense(frames);
    for (SenseFrame& frame : frames) frame.time_s = clock_(frame.time_s);
  }
  void step(std::span<const ActFrame> frames, double step_s) noexcept override { inner_.step(frames, step_s); }

 private:
  Application& inner_;
  Clock clock_;
};

/// What a doctor finds wrong with a robot that runs freely under another controller.
std::string found_wrong(Spoilt::Clock clock) {
  NotebookRobot notebook(1);
  Spoilt robot(notebook, clock);
  RobotEnd end(robot, robot_config());
  RemoteConfig config;
  config.end.pace = wire::FREE_RUNNING;
  auto driver = RemoteApplication::connect(std::make_unique<MemoryLine>(end), robot.description(), 1, config);
  EXPECT_TRUE(driver);
  std::string wrong;
  examine(std::make_unique<MemoryLine>(end), [&](bool good, const Sentence& finding) {
    if (!good) wrong += finding.en + "\n";
  });
  return wrong;
}

TEST(Examination, FindsNothingWrongWithAClockThatGrows) {
  EXPECT_EQ(found_wrong([](double time_s) { return time_s; }), "");
}

TEST(Examination, TellsOfAClockThatStandsAndOfOneThatCountsMilliseconds) {
  EXPECT_NE(found_wrong([](double) { return 0.0; }).find("clock stands at 0 s"), std::string::npos);
  EXPECT_NE(found_wrong([](double time_s) { return 1000 * time_s; }).find("are these seconds?"), std::string::npos);
}

}  // namespace
}  // namespace ganglion::link
