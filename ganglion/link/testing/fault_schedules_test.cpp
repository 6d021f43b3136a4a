#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

#include "ganglion/base/hash.h"
#include "ganglion/link/testing/bench.h"
#include "ganglion/link/testing/faulty_memory_line.h"
#include "ganglion/link/testing/watched_robot.h"

// Sessions through schedules of faults drawn from seeds, in a time of their own: both ends, every carrier, encoding and
// pace. `GANGLION_SCHEDULES=10000` runs that many in each manner, and each of them twice.
namespace ganglion::link {
namespace {

constexpr int kTicks = 60;
constexpr double kStep_s = 0.1;
constexpr double kForever_s = 1e9;
constexpr double kHang_s = 1;  // beyond what the link's own deadlines explain

const char* many() { return std::getenv("GANGLION_SCHEDULES"); }

std::uint64_t schedules(Encoding encoding) {
  if (many() != nullptr) return std::strtoull(many(), nullptr, 10);
  return encoding == Encoding::Json ? 100 : 500;  // reading JSON takes most of the time
}

/// How a session is held.
struct Manner {
  Carrier carrier = Carrier::Stream;
  Encoding encoding = Encoding::Binary;
  wire::Pace pace = wire::LOCK_STEP;
};

struct Outcome {
  std::string failure;       ///< In words; "" where the session came to its end.
  std::string broken;        ///< The temporal rule that was broken.
  std::uint64_t hash = 0;    ///< Of all bytes that arrived, and when.
  std::uint64_t sensed = 0;  ///< Of all the controller sensed.
  std::vector<NotebookRobot::Done> done;
  double longest_s = 0;  ///< From the last fault that struck to the end of an exchange, longest.
  bool rests = false;    ///< Free-running: left alone for 2 s, the robot has taken its safe values.
};

void note(const SenseFrame& frame, std::uint64_t& hash) {
  for (const double value : frame.values) hash = combine(hash, canonical_bits(value));
  for (const double age_s : frame.ages_s) hash = combine(hash, canonical_bits(age_s));
  hash = combine(hash, canonical_bits(frame.cost.value_or(-1)));
  hash = combine(hash, canonical_bits(frame.time_s));
}

/// Drives as a run does, a tenth of a second of thought each tick.
void drive(RemoteApplication& remote, FaultyMemoryLine& line, Outcome& outcome) {
  const auto took = [&](double begun_s) {
    outcome.longest_s = std::max(outcome.longest_s, line.now_s() - std::max(begun_s, line.struck_s()));
  };
  double begun_s = line.now_s();
  const auto reset = remote.reset(7, 0);
  if (reset) took(begun_s);
  std::vector<SenseFrame> sense = {make_sense_frame(remote.description())};
  std::vector<ActFrame> act = {make_act_frame(remote.description())};
  for (int tick = 0; tick < kTicks && remote.failure() == nullptr; ++tick) {
    begun_s = line.now_s();
    remote.sense(sense);
    if (remote.failure() == nullptr) took(begun_s);
    make_canonical(sense[0]);
    note(sense[0], outcome.sensed);
    decide(sense[0], act[0]);
    line.wait_until(line.now_s() + kStep_s / 2);
    begun_s = line.now_s();
    remote.step(act, kStep_s);
    if (remote.failure() == nullptr) took(begun_s);
  }
  if (remote.failure() != nullptr) outcome.failure = remote.failure()->what.en;
}

Outcome hold(const Manner& manner, const LineFaults& faults, std::uint64_t seed) {
  Outcome outcome;
  NotebookRobot robot;
  FaultyMemoryLine* line = nullptr;
  WatchedRobot watched(robot, manner.pace, [&line] { return line == nullptr ? 0 : line->now_s(); });
  EXPECT_TRUE(watched.reset(1, 0));
  RobotEndConfig config = robot_config();
  config.lock_step = manner.pace == wire::LOCK_STEP;
  config.free_running = !config.lock_step;
  RobotEnd end(watched, config);
  auto made = std::make_unique<FaultyMemoryLine>(end, faults, seed, manner.carrier);
  line = made.get();
  line->arriving = [&](Way way, std::uint32_t connection, std::string_view bytes, double) {
    if (way == Way::ToRobot) watched.heard(connection, manner.carrier, bytes);
  };
  RemoteConfig remote_config;
  remote_config.end.encoding = manner.encoding;
  remote_config.end.pace = manner.pace;
  auto remote = RemoteApplication::connect(std::move(made), robot.description(), 1, remote_config);
  if (!remote) {
    outcome.failure = remote.error().what.en;
    outcome.broken = watched.broken();
    return outcome;
  }
  outcome.longest_s = line->now_s() - line->struck_s();
  drive(**remote, *line, outcome);
  outcome.hash = line->log_hash();
  outcome.done = robot.done();
  line->wait_until(std::max(line->now_s(), line->struck_s()) + 2);
  outcome.rests = robot.done().empty() || robot.done().back().origin == CommandOrigin::Safe;
  outcome.broken = watched.broken();
  return outcome;
}

/// The longest an exchange may take from the last fault that struck: a stream is given up after 3 s of silence, packets
/// are repeated after 0.3 s, and the way there and back takes its time, a second greeting included. What changed bytes
/// of a stream announce may be awaited until the link is given up, after 15 s.
double deadline_s(const Manner& manner, const LineFaults& faults, bool mendable) {
  if (!mendable) return RemoteConfig().end.patience_s;
  double way_s = kMergePatience_s + 4 * kSplitGap_s;
  for (const LineFault& fault : faults) way_s += fault.delay_s + fault.jitter_s;
  return (manner.carrier == Carrier::Stream ? 3 : 0.3) + kStep_s + 4 * way_s;
}

std::string text_of(const Manner& manner, const LineFaults& faults, std::uint64_t seed) {
  return fmt::format("{} {} {} seed {}: --faults \"{}\"", manner.carrier == Carrier::Stream ? "stream" : "packets",
                     manner.encoding == Encoding::Json ? "json" : "binary",
                     manner.pace == wire::LOCK_STEP ? "lock-step" : "free-running", seed, link::text_of(faults));
}

/// Schedules of every fault there is, in one manner of session.
class FaultSchedules : public ::testing::TestWithParam<Manner> {};

TEST_P(FaultSchedules, NeitherHangNorBreakARuleOfTime) {
  const Manner manner = GetParam();
  const bool checked = manner.carrier == Carrier::Packets;  // by a checksum: nothing that was changed gets through
  std::uint64_t failed = 0;
  double longest_s = 0, beyond_s = -kForever_s;
  const Outcome whole = hold(manner, {}, 0);
  ASSERT_EQ(whole.failure, "");
  for (std::uint64_t seed = 0; seed < schedules(manner.encoding); ++seed) {
    const Hardness hardness = checked || seed % 4 == 0 ? Hardness::Any : Hardness::Mendable;
    const LineFaults faults = drawn_line_faults(seed, hardness);
    const std::string what = text_of(manner, faults, seed);
    SCOPED_TRACE(what);
    const Outcome outcome = hold(manner, faults, seed);
    const bool mendable = hardness == Hardness::Mendable || checked;
    EXPECT_EQ(outcome.broken, "");
    EXPECT_LE(outcome.longest_s, deadline_s(manner, faults, mendable) + kHang_s);
    if (mendable) {
      EXPECT_EQ(outcome.failure, "");
    }
    EXPECT_TRUE(outcome.rests || manner.pace == wire::LOCK_STEP || !outcome.failure.empty());
    if (mendable && manner.pace == wire::LOCK_STEP) {
      EXPECT_EQ(outcome.done, whole.done);
      EXPECT_EQ(outcome.sensed, whole.sensed);
    }
    if (HasFailure()) return;
    failed += outcome.failure.empty() ? 0 : 1;
    longest_s = std::max(longest_s, outcome.longest_s);
    beyond_s = std::max(beyond_s, outcome.longest_s - deadline_s(manner, faults, mendable));
    if (seed % 16 == 0 || many() != nullptr) {
      EXPECT_EQ(hold(manner, faults, seed).hash, outcome.hash);
    }
  }
  std::printf("  %llu schedules, %llu given up in words, longest exchange %.3f s (%+.3f s to its deadline)\n",
              static_cast<unsigned long long>(schedules(manner.encoding)), static_cast<unsigned long long>(failed),
              longest_s, beyond_s);
}

INSTANTIATE_TEST_SUITE_P(EveryManner, FaultSchedules,
                         ::testing::Values(Manner{Carrier::Stream, Encoding::Binary, wire::LOCK_STEP},
                                           Manner{Carrier::Stream, Encoding::Json, wire::LOCK_STEP},
                                           Manner{Carrier::Packets, Encoding::Binary, wire::LOCK_STEP},
                                           Manner{Carrier::Packets, Encoding::Json, wire::LOCK_STEP},
                                           Manner{Carrier::Stream, Encoding::Binary, wire::FREE_RUNNING},
                                           Manner{Carrier::Packets, Encoding::Binary, wire::FREE_RUNNING}));

}  // namespace
}  // namespace ganglion::link
