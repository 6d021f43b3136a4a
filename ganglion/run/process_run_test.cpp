#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>

#include "ganglion/run/replay.h"
#include "ganglion/run/run.h"

// A regulator holds a plant at set-points: experiments/process.
namespace ganglion {
namespace {

namespace fs = std::filesystem;

const fs::path kProcess = fs::path(GANGLION_SOURCE_DIR) / "experiments/process";

Prepared prepared(const std::vector<config::Override>& overrides = {}) {
  Problems problems;
  auto made = prepare(kProcess, overrides, problems);
  EXPECT_EQ(problems.text(), "");
  return made.value();
}

/// The loop of a lag and a regulator with proportional and integral parts, sampled: with a = exp(-T / lag) the error e
/// and the integral follow a linear map of trace a - (1 - a) kp + 1 and determinant a - (1 - a) kp + (1 - a) ki T, so that
/// e_k = r^k (A cos k f + B sin k f) with r^2 the determinant and 2 r cos f the trace; e_0 = -1, e_1 = (1 - a) kp - 1.
struct SampledLoop {
  static constexpr double kStep_s = 0.1, kLag_s = 2, kKp = 2, kKi = 3;
  double error(int k) const { return std::pow(radius, k) * (-std::cos(k * angle) + sine * std::sin(k * angle)); }
  double share = 1 - std::exp(-kStep_s / kLag_s);
  double radius = std::sqrt(1 - share - share * kKp + share * kKi * kStep_s);
  double angle = std::acos((2 - share - share * kKp) / (2 * radius));
  double sine = ((share * kKp - 1) / radius + std::cos(angle)) / std::sin(angle);
};

TEST(AProcess, IsHeldAsTheSampledLoopSaysByHand) {
  const SampledLoop loop;
  double overshoot = 0, settling_s = 0;
  for (int k = 0; k <= 150; ++k) {
    overshoot = std::max(overshoot, loop.error(k));
    if (std::fabs(loop.error(k)) > 0.02) settling_s = k * SampledLoop::kStep_s;
  }
  EXPECT_NEAR(overshoot, 0.178, 0.001) << "the loop is the one that was reckoned with";
  const auto result = run(prepared(), {.seed = 1});
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_EQ(result->verdict, Verdict::Succeeded) << result->reason.en;
  EXPECT_NEAR(measure(result->measures, "overshoot"), overshoot, 0.01 * overshoot);
  EXPECT_NEAR(measure(result->measures, "settling_s"), settling_s, 0.01 * settling_s);
}

TEST(AProcess, IsReplayed) {
  const fs::path file = fs::temp_directory_path() / fmt::format("ganglion_process_{}.mcap", ::getpid());
  const auto result = run(prepared({{"run.duration_s", "10"}}), {.seed = 2, .run_file = file});
  ASSERT_TRUE(result) << result.error().text();
  const auto again = replay_run(file);
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_TRUE(again->same);
  EXPECT_EQ(again->digest, result->digest);
  fs::remove(file);
}

TEST(AProcess, HasNoFiguresOfGroundAndRefusesAWorld) {
  std::vector<std::string> names;
  for (const Figure& figure : prepared().figures) names.push_back(figure.name);
  EXPECT_EQ(names, (std::vector<std::string>{"duration_s", "overshoot", "settling_s", "mean_error"}));
  Problems problems;
  const fs::path world = fs::path(GANGLION_SOURCE_DIR) / "experiments/nimrod/office.toml";
  EXPECT_FALSE(prepare(kProcess, {{"application.world", world.string()}}, problems));
  EXPECT_NE(problems.text().find("a plant stands in no world: leave it out"), std::string::npos) << problems.text();
}

TEST(AProcess, DrawsItsNoiseByTheSeed) {
  const Prepared noisy = prepared({{"run.duration_s", "5"}, {"application.robot.noise", "0.1"}});
  const auto digest = [&](std::uint64_t seed) { return run(noisy, {.seed = seed})->digest; };
  EXPECT_EQ(digest(1), digest(1));
  EXPECT_NE(digest(1), digest(2));
}

}  // namespace
}  // namespace ganglion
