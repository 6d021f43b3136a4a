#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>

#include "ganglion/graph/controller.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/link/controller/remote_application.h"
#include "ganglion/link/testing/bench.h"
#include "ganglion/random/draws.h"
#include "ganglion/run/prepared.h"

// Nimrod's controller drives a cart towards a wall over the link, and the cart's clock fails. No old reading may be taken
// for new: the cart never meets its wall.
namespace ganglion {
namespace {

constexpr double kWall_m = 3, kSpeed_mps = 0.2, kAxle_m = 0.18;

/// Told time of a true one, as a clock that fails at `at_s` shows it.
using Clock = std::function<double(double now_s, double at_s)>;

/// The cart of clients/python: two wheels, two sonars that look at one wall, a compass.
class WallCart final : public Application {
 public:
  WallCart(const Description& description, Clock clock, double at_s)
      : description_(description), clock_(std::move(clock)), at_s_(at_s) {}
  double nearest_m() const noexcept { return nearest_m_; }
  /// How far from its wall it turned; 0 where it did not.
  double turned_m() const noexcept { return turned_m_; }

  const Description& description() const noexcept override { return description_; }
  int robots() const noexcept override { return 1; }
  Result<void> reset(std::uint64_t, std::uint32_t) override {
    x_m_ = yaw_rad_ = now_s_ = 0;
    tick_ = 0;
    nearest_m_ = kWall_m;
    return {};
  }
  void sense(std::span<SenseFrame> frames) noexcept override {
    const double ahead = std::cos(yaw_rad_), range_m = ahead > 0.1 ? (kWall_m - x_m_) / ahead : HUGE_VAL;
    SenseFrame& frame = frames[0];
    frame.tick = tick_;
    frame.time_s = clock_(now_s_, at_s_);
    const double read_m = range_m < 3 ? range_m : HUGE_VAL;
    frame.values = {read_m, read_m, yaw_rad_};
    frame.ages_s = {0, 0, 0};
    frame.cost.reset();
  }
  void step(std::span<const ActFrame> frames, double step_s) noexcept override {
    const double left = frames[0].values[0], right = frames[0].values[1];
    x_m_ += kSpeed_mps * (left + right) / 2 * std::cos(yaw_rad_) * step_s;
    yaw_rad_ = std::remainder(yaw_rad_ + kSpeed_mps * (right - left) / kAxle_m * step_s, 2 * 3.14159265358979323846);
    nearest_m_ = std::min(nearest_m_, kWall_m - x_m_);
    if (turned_m_ == 0 && std::abs(yaw_rad_) > 0.2) turned_m_ = kWall_m - x_m_;
    now_s_ += step_s;
    ++tick_;
  }

 private:
  Description description_;
  Clock clock_;
  double at_s_;
  double x_m_ = 0, yaw_rad_ = 0, now_s_ = 0, nearest_m_ = kWall_m, turned_m_ = 0;
  std::uint32_t tick_ = 0;
};

struct Drive {
  double nearest_m = 0, turned_m = 0;
  double newest_s = 0;  ///< When the newest reading was measured.
  std::string end;      ///< Why the link was given up; "" where it was not.
  std::string told;     ///< What it told on the way.
};

struct Link {
  link::Carrier carrier = link::Carrier::Stream;
  link::wire::Pace pace = link::wire::LOCK_STEP;
};
constexpr Link kLinks[] = {{link::Carrier::Stream, link::wire::LOCK_STEP},
                           {link::Carrier::Packets, link::wire::LOCK_STEP},
                           {link::Carrier::Stream, link::wire::FREE_RUNNING},
                           {link::Carrier::Packets, link::wire::FREE_RUNNING}};

const Prepared& cart() {
  static const Prepared kCart = [] {
    Problems problems;
    auto made = prepare(std::filesystem::path(GANGLION_SOURCE_DIR) / "clients/python", {}, problems);
    EXPECT_EQ(problems.text(), "");
    return made.value();
  }();
  return kCart;
}

Drive drive(const Clock& clock, double at_s, const Link& how, double duration_s = 60) {
  const Description& description = cart().application->description();
  WallCart robot(description, clock, at_s);
  EXPECT_TRUE(robot.reset(1, 0));
  link::RobotEnd end(robot, link::robot_config());
  link::RemoteConfig config;
  config.end.pace = how.pace;
  auto remote =
      link::RemoteApplication::connect(std::make_unique<link::MemoryLine>(end, how.carrier), description, 1, config);
  if (!remote) return {.end = remote.error().what.en};
  auto controller = Controller::compile(cart().controller, description, controller_kinds(), {1, 0, 0});
  EXPECT_TRUE(controller && (*remote)->reset(1, 0));
  std::vector<SenseFrame> sense{make_sense_frame(description)};
  std::vector<ActFrame> act{make_act_frame(description)};
  Drive result;
  double before_s = -1;
  for (int tick = 0; tick < duration_s / 0.1 && (*remote)->failure() == nullptr; ++tick) {
    (*remote)->sense(sense);
    if ((*remote)->failure() != nullptr) break;
    EXPECT_GT(sense[0].time_s, before_s);
    before_s = sense[0].time_s;
    result.newest_s = std::max(result.newest_s, sense[0].time_s - sense[0].ages_s[0]);
    controller->tick(sense[0], 0.1, act[0]);
    (*remote)->step(act, 0.1);
  }
  if ((*remote)->failure() != nullptr) result.end = (*remote)->failure()->what.en;
  for (const link::wire::Event& event : (*remote)->take_events()) result.told += event.text() + "\n";
  remote->reset();  // says goodbye
  result.nearest_m = robot.nearest_m();
  result.turned_m = robot.turned_m();
  return result;
}

/// As many moments as GANGLION_MOMENTS says, or a few.
std::vector<double> moments() {
  const char* asked = std::getenv("GANGLION_MOMENTS");
  const int count = asked != nullptr ? std::atoi(asked) : 5;
  std::vector<double> moments;
  for (int n = 0; n < count; ++n) {
    moments.push_back(Draws({25}, static_cast<std::uint32_t>(n)).uniform(0.3, 25));
  }
  return moments;
}

/// The cart comes to its wall, and turns.
void expect_carried_on(const char* what, const Clock& clock) {
  for (const double at_s : moments()) {
    for (const Link& how : kLinks) {
      const Drive drove = drive(clock, at_s, how);
      const auto where = fmt::format("{} at {} s, carrier {}, pace {}: {}", what, at_s, static_cast<int>(how.carrier),
                                     static_cast<int>(how.pace), drove.told);
      EXPECT_EQ(drove.end, "") << where;
      EXPECT_GE(drove.nearest_m, 0.005) << where;
      EXPECT_LE(drove.turned_m, 0.5) << where;
      EXPECT_GT(drove.turned_m, 0) << where;
      EXPECT_NE(drove.told, "") << where;
    }
  }
}

TEST(CartWithAGoodClock, TurnsBeforeItsWallOverEveryLink) {
  for (const Link& how : kLinks) {
    const Drive drove = drive([](double now_s, double) { return now_s; }, 0, how);
    EXPECT_EQ(drove.end + drove.told, "");
    EXPECT_NEAR(drove.turned_m, 0.31, 0.02);
    EXPECT_GE(drove.nearest_m, 0.005);
  }
}

TEST(CartWhoseClock, WrapsIsDrivenOn) {
  for (const double span_s : {4294.967296, 4294967.296}) {
    expect_carried_on("wraps",
                      [span_s](double now_s, double at_s) { return std::fmod(span_s - at_s + now_s, span_s); });
  }
}

TEST(CartWhoseClock, GoesBackIsDrivenOn) {
  expect_carried_on("goes back", [](double now_s, double at_s) { return 3600 + now_s - (now_s >= at_s ? 3600 : 0); });
}

TEST(CartWhoseClock, JumpsIsDrivenOn) {
  expect_carried_on("jumps", [](double now_s, double at_s) { return now_s + (now_s >= at_s ? 1e6 : 0); });
  expect_carried_on("is wrong once",
                    [](double now_s, double at_s) { return now_s + (now_s >= at_s && now_s < at_s + 0.15 ? 500 : 0); });
}

TEST(CartWhoseClock, StandsEndsInWords) {
  for (const double at_s : moments()) {
    for (const Link& how : kLinks) {
      const Drive drove = drive([](double now_s, double stands_s) { return std::min(now_s, stands_s); }, at_s, how);
      EXPECT_GE(drove.nearest_m, 0.005) << at_s;
      EXPECT_LE(drove.newest_s, at_s + 1e-9) << "nothing shows that it read anything later";
      EXPECT_NE(drove.end.find("the robot's clock stands at"), std::string::npos) << at_s << drove.end;
    }
  }
}

TEST(CartWhoseClock, IsNotToldEndsInWords) {
  for (const Link& how : kLinks) {
    const Drive drove = drive([](double, double) { return 0.0; }, 0, how);
    EXPECT_GE(drove.nearest_m, 2.9);
    EXPECT_NE(drove.end.find("its Sense must tell time_s"), std::string::npos) << drove.end;
  }
}

TEST(CartWhoseClock, CountsMillisecondsForSecondsEndsInWords) {
  for (const Link& how : kLinks) {
    const Drive drove = drive([](double now_s, double) { return 1000 * now_s; }, 0, how);
    EXPECT_GE(drove.nearest_m, 2.9);
    EXPECT_NE(drove.end.find("are these seconds?"), std::string::npos) << drove.end;
  }
}

}  // namespace
}  // namespace ganglion
