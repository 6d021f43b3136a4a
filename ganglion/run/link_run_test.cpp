#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <thread>

#include "ganglion/base/file.h"
#include "ganglion/link/net/lines.h"
#include "ganglion/link/net/proxy.h"
#include "ganglion/link/net/server.h"
#include "ganglion/link/net/testing/serving.h"
#include "ganglion/record/run_file.h"
#include "ganglion/run/run_robots.h"

// The same experiment and seed, its robots in this program or at the other end of a link.
namespace ganglion {
namespace {

namespace fs = std::filesystem;

const fs::path kExperiments = fs::path(GANGLION_SOURCE_DIR) / "experiments";

using Sets = std::vector<std::string>;

Prepared prepared(const char* experiment, const Sets& sets) {
  std::vector<config::Override> overrides;
  for (const std::string& text : sets) overrides.push_back(*config::parse_override(text));
  Problems problems;
  auto made = prepare(kExperiments / experiment, overrides, problems);
  EXPECT_EQ(problems.text(), "");
  return made.value();
}

/// What `ganglion sim` does, in a thread.
class Served {
 public:
  Served(const Prepared& prepared, const std::string& address) : application_(prepared.application->make().value()) {
    EXPECT_TRUE(application_->reset(99, 0));
    link::RobotEndConfig config;
    config.token = link::random_token;
    end_ = std::make_unique<link::RobotEnd>(*application_, config);
    serving_ = std::make_unique<link::Serving>(*end_, address);
  }
  void stop() { serving_->stop(); }
  std::string address() const { return serving_->address().text; }

 private:
  std::unique_ptr<Application> application_;
  std::unique_ptr<link::RobotEnd> end_;
  std::unique_ptr<link::Serving> serving_;
};

/// Two pseudo-terminals joined back to back: a serial cable.
class Cable {
 public:
  Cable() {
    for (End& end : ends_) {
      end.master = ::posix_openpt(O_RDWR | O_NOCTTY);
      EXPECT_GE(end.master, 0);
      EXPECT_EQ(::grantpt(end.master) + ::unlockpt(end.master), 0);
      end.name = ::ptsname(end.master);
      end.held = ::open(end.name.c_str(), O_RDWR | O_NOCTTY);  // so that the master never sees a hang-up
      termios raw{};
      ::tcgetattr(end.held, &raw);
      ::cfmakeraw(&raw);
      ::tcsetattr(end.held, TCSANOW, &raw);
    }
    thread_ = std::jthread([this](const std::stop_token& stop) { carry(stop); });
  }
  ~Cable() {
    thread_.request_stop();
    thread_.join();
    for (const End& end : ends_) {
      ::close(end.held);
      ::close(end.master);
    }
  }
  std::string address(int end) const { return "serial://" + ends_[end].name; }

 private:
  struct End {
    int master = -1, held = -1;
    std::string name;
  };
  void carry(const std::stop_token& stop) {
    char room[4096];
    while (!stop.stop_requested()) {
      pollfd both[2] = {{ends_[0].master, POLLIN, 0}, {ends_[1].master, POLLIN, 0}};
      if (::poll(both, 2, 20) <= 0) continue;
      for (int n = 0; n < 2; ++n) {
        if ((both[n].revents & POLLIN) == 0) continue;
        const ssize_t got = ::read(ends_[n].master, room, sizeof room);
        for (ssize_t at = 0; at < got;) {
          const ssize_t put = ::write(ends_[1 - n].master, room + at, static_cast<std::size_t>(got - at));
          if (put > 0) at += put;
        }
      }
    }
  }
  End ends_[2];
  std::jthread thread_;
};

std::string digest(const Prepared& prepared) {
  const auto result = run(prepared, {.seed = 5});
  EXPECT_TRUE(result) << result.error().text();
  if (!result) return "none";
  EXPECT_FALSE(result->link_lost) << result->link_lost->text();
  return result->digest;
}

void expect_same_over_every_link(const char* experiment, Sets sets) {
  const Prepared here = prepared(experiment, sets);
  const std::string expected = digest(here);
  const auto over = [&](const std::string& address, const char* encoding) {
    Sets remote = sets;
    remote.push_back("application.address=" + address);
    remote.push_back(std::string("application.encoding=") + encoding);
    return digest(prepared(experiment, remote));
  };
  {
    const Served served(here, "127.0.0.1:0");
    EXPECT_EQ(over(served.address(), "binary"), expected);
    EXPECT_EQ(over(served.address(), "json"), expected);
  }
  const Cable cable;
  const Served served(here, cable.address(0));
  EXPECT_EQ(over(cable.address(1), "binary"), expected);
  EXPECT_EQ(over(cable.address(1), "json"), expected);
}

TEST(LinkRun, GivesTheDigestOfARunInProcess) {
  expect_same_over_every_link("nimrod", {"run.duration_s=30"});
  expect_same_over_every_link("pathfinder", {"run.duration_s=200"});
}

TEST(LinkRun, GivesTheDigestOfAPlant) {
  expect_same_over_every_link("process", {"run.duration_s=20"});
  expect_same_over_every_link("process/loads.toml", {"run.duration_s=40"});
}

TEST(LinkRun, CarriesTruthAndLedgersOfAPlant) {
  const Prepared here = prepared("process", {"run.duration_s=29"});
  const Served served(here, "127.0.0.1:0");
  const auto there =
      run(prepared("process", {"run.duration_s=29", "application.address=" + served.address()}), {.seed = 5});
  const auto in_process = run(here, {.seed = 5});
  ASSERT_TRUE(there && in_process);
  EXPECT_GT(measure(in_process->measures, "overshoot"), 0.1);
  EXPECT_EQ(there->measures, in_process->measures);
}

TEST(LinkRun, GivesTheDigestOfARunInProcessWithFaultsAndMovers) {
  expect_same_over_every_link(
      "pathfinder",
      {"run.duration_s=100", "application.world=" + (kExperiments / "pathfinder" / "rooms_moving.toml").string()});
  const fs::path listing = kExperiments / "nimrod" / "controller.listing_raw.toml";
  expect_same_over_every_link("nimrod",
                              {"run.duration_s=30", "run.free_ground=false", "controller=" + listing.string()});
}

TEST(LinkRun, GivesTheDigestOfAHundredRobots) {
  const fs::path world = fs::temp_directory_path() / fmt::format("ganglion_link_hall_{}.toml", ::getpid());
  ASSERT_TRUE(write_file(world,
                         "format = 1\nname = \"hall\"\n[[wall]]\npoints = [[0, 0], [90, 0], [90, 90], [0, 90]]\n"
                         "closed = true\n"));
  expect_same_over_every_link("nimrod", {"run.duration_s=5", "run.free_ground=false", "application.robots=100",
                                         "application.world=" + world.string()});
  fs::remove(world);
}

/// Latency and loss as an experiment has them.
Prepared with_faults(Prepared prepared) {
  const auto add = [&prepared](const char* target, FaultKind kind, double amount) {
    Fault fault;
    fault.target = target;
    fault.kind = kind;
    fault.amount = amount;
    prepared.experiment.faults.push_back(fault);
  };
  add("frames", FaultKind::Late, 0.2);
  add("frames", FaultKind::Lost, 0.2);
  add("commands", FaultKind::Lost, 0.1);
  return prepared;
}

TEST(LinkRun, SuffersTheFaultsOfItsExperimentAsInProcess) {
  const Sets sets = {"run.duration_s=30"};
  const Prepared here = prepared("nimrod", sets);
  const std::string expected = digest(with_faults(here));
  EXPECT_NE(expected, digest(here));
  const Served served(here, "127.0.0.1:0");
  const Prepared remote = prepared("nimrod", {sets[0], "application.address=" + served.address()});
  EXPECT_EQ(digest(with_faults(remote)), expected);
}

TEST(LinkRun, GivesItsDigestAndAWholeFileThroughAFaultyLine) {
  const Sets sets = {"run.duration_s=20"};
  const Prepared here = prepared("nimrod", sets);
  const Served served(here, "127.0.0.1:0");
  auto proxy = link::Proxy::listen({*link::parse_address("127.0.0.1:0"),
                                    *link::parse_address(served.address()),
                                    *link::parse_line_faults("merge=1%,split=30%; fin=1%,rst=1%"),
                                    3,
                                    {}});
  ASSERT_TRUE(proxy) << proxy.error().what.en;
  const std::jthread thread(
      [&proxy](const std::stop_token& stop) { (*proxy)->serve([&stop] { return stop.stop_requested(); }); });
  const Prepared remote = prepared("nimrod", {sets[0], "application.address=" + (*proxy)->address().text});
  RunOptions options;
  options.seed = 5;
  options.run_file = fs::temp_directory_path() / fmt::format("ganglion_link_proxy_{}.mcap", ::getpid());
  const auto result = run(remote, options);
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_FALSE(result->link_lost);
  EXPECT_EQ(result->digest, digest(here));
  const auto file = RunFile::read(options.run_file);
  ASSERT_TRUE(file) << file.error().text();
  EXPECT_EQ(file->table("/robot0/signals")->rows(), 200u);  // of 20 s at 0.1 s
  fs::remove(options.run_file);
}

TEST(LinkRun, LeavesAWholeFileWhenTheRobotGoesAway) {
  const Prepared here = prepared("nimrod", {"run.free_ground=false"});
  Served served(here, "127.0.0.1:0");
  const Prepared remote = prepared("nimrod", {"run.free_ground=false", "application.address=" + served.address()});
  RunOptions options;
  options.run_file = fs::temp_directory_path() / fmt::format("ganglion_link_lost_{}.mcap", ::getpid());
  options.progress = [&served, ticks = 0](double) mutable {
    if (++ticks == 50) served.stop();
    return true;
  };
  const auto result = run(remote, options);
  ASSERT_TRUE(result) << result.error().text();
  ASSERT_TRUE(result->link_lost);
  EXPECT_EQ(result->verdict, Verdict::Failed);
  const auto file = RunFile::read(options.run_file);
  ASSERT_TRUE(file) << file.error().text();
  const Sentence& reason = file->outcome->reason;
  EXPECT_TRUE(reason.en.starts_with("link lost: ")) << reason.en;
  EXPECT_TRUE(reason.es.starts_with("enlace perdido: ")) << reason.es;
  EXPECT_EQ(file->table("/robot0/signals")->rows(), 51u);
  ASSERT_NE(file->table("/link/signals"), nullptr);
  EXPECT_GT(file->table("/link/signals")->at(10, 0), 0);  // the round trip [s]
  fs::remove(options.run_file);
}

}  // namespace
}  // namespace ganglion
