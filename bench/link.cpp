// What the robot link costs: wall time of one exchange of Act and Sense with a robot that does nothing, beside a bare
// TCP ping-pong of the same numbers of bytes in the same run. And how regular a loop of 100 Hz stays while strangers
// storm the robot.
#include <arpa/inet.h>
#include <netinet/tcp.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "bench/support/rows.h"
#include "ganglion/link/controller/remote_application.h"
#include "ganglion/link/net/lines.h"
#include "ganglion/link/net/server.h"

namespace {

using namespace ganglion;
using namespace ganglion::bench;

constexpr int kExchanges = 10'000, kWarmUp = 500;

/// Three sonars and two wheels, and nothing behind them.
class IdleRobots final : public Application {
 public:
  explicit IdleRobots(int robots) : robots_(robots) {
    description_.name = "Idle";
    for (const char* name : {"sonar_left.range", "sonar_right.range", "compass.heading"}) {
      description_.sensations.push_back({.name = name, .unit = "m", .max = 3});
    }
    description_.commands = {{"drive", {{"left"}, {"right"}}}};
  }
  const Description& description() const noexcept override { return description_; }
  int robots() const noexcept override { return robots_; }
  Result<void> reset(std::uint64_t, std::uint32_t) override {
    tick_ = 0;
    return {};
  }
  void sense(std::span<SenseFrame> frames) noexcept override {
    for (SenseFrame& frame : frames) {
      frame.tick = tick_;
      frame.time_s = 0.1 * tick_;
      std::fill(frame.values.begin(), frame.values.end(), 1.25);
      std::fill(frame.ages_s.begin(), frame.ages_s.end(), 0.05);
      frame.cost = 0.5;
    }
  }
  void step(std::span<const ActFrame>, double) noexcept override { ++tick_; }

 private:
  Description description_;
  int robots_;
  std::uint32_t tick_ = 0;
};

/// Another process that ends with this object.
class Child {
 public:
  template <class Work>
  explicit Child(Work&& work) : process_(::fork()) {
    if (process_ != 0) return;
    work();
    ::_exit(0);
  }
  ~Child() {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  Child(const Child&) = delete;

 private:
  pid_t process_;
};

/// Robots at the other end of a link, in a process of their own.
class Linked {
 public:
  explicit Linked(int robots, link::Encoding encoding = link::Encoding::Binary)
      : idle_(robots),
        end_(idle_, config()),
        server_(listening(end_)),
        child_([this] { server_->serve([] { return false; }, {}); }) {
    link::RemoteConfig remote;
    remote.end.encoding = encoding;
    remote_ = link::RemoteApplication::connect(link::make_line(server_->address()), idle_.description(), robots, remote)
                  .value();
    act_.assign(static_cast<std::size_t>(robots), make_act_frame(idle_.description()));
    for (ActFrame& frame : act_) frame.origins = {CommandOrigin::Commanded};
  }
  void exchange() { remote_->step(act_, 0.1); }
  bool alive() const { return remote_->failure() == nullptr; }
  std::uint16_t port() const { return server_->address().port; }
  const std::vector<ActFrame>& act() const { return act_; }
  IdleRobots& idle() { return idle_; }

 private:
  static link::RobotEndConfig config() {
    link::RobotEndConfig config;
    config.token = link::random_token;
    return config;
  }
  static std::unique_ptr<link::Server> listening(link::RobotEnd& end) {
    return link::Server::listen(end, *link::parse_address("127.0.0.1:0")).value();
  }
  IdleRobots idle_;
  link::RobotEnd end_;
  std::unique_ptr<link::Server> server_;
  Child child_;
  std::unique_ptr<link::RemoteApplication> remote_;
  std::vector<ActFrame> act_;
};

double us_per_exchange(int robots, link::Encoding encoding) {
  Linked linked(robots, encoding);
  for (int n = 0; n < kWarmUp; ++n) linked.exchange();
  const double began_s = link::steady_s();
  for (int n = 0; n < kExchanges; ++n) linked.exchange();
  return linked.alive() ? (link::steady_s() - began_s) * 1e6 / kExchanges : NAN;
}

struct Sizes {
  std::size_t act = 0, sense = 0;
};

/// Bytes of both frames as they go over TCP.
Sizes sizes_of(int robots, link::Encoding encoding) {
  IdleRobots idle(robots);
  link::LinkedRobot robot(idle);
  link::wire::Sense sense;
  robot.write(false, sense);
  sense.set_tick(kExchanges / 2);
  link::wire::Act act;
  act.set_tick(kExchanges / 2);
  act.set_step_s(0.1);
  ActFrame frame = make_act_frame(idle.description());
  frame.origins = {CommandOrigin::Commanded};
  link::write_acts(std::vector<ActFrame>(static_cast<std::size_t>(robots), frame), false, act);
  std::string act_bytes, sense_bytes;
  link::FrameWriter writer(link::Carrier::Stream, encoding);
  const bool fits = writer.append(act, act_bytes) && writer.append(sense, sense_bytes);
  return fits ? Sizes{act_bytes.size(), sense_bytes.size()} : Sizes{};
}

void all(int socket, std::vector<char>& bytes, bool sending) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t done = sending ? ::write(socket, bytes.data() + at, bytes.size() - at)
                                 : ::read(socket, bytes.data() + at, bytes.size() - at);
    if (done <= 0) ::_exit(1);
    at += static_cast<std::size_t>(done);
  }
}

/// A bare ping-pong between two processes: blocking sockets, no delay.
double us_per_ping_pong(Sizes sizes) {
  const int listener = ::socket(AF_INET, SOCK_STREAM, 0), one = 1;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* plain = reinterpret_cast<sockaddr*>(&address);
  if (::bind(listener, plain, size) != 0 || ::listen(listener, 1) != 0) return NAN;
  ::getsockname(listener, plain, &size);
  std::vector<char> act(sizes.act), sense(sizes.sense);
  const Child robot([&] {
    const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
    if (::connect(socket, plain, size) != 0) return;
    ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
    for (;;) {
      all(socket, act, false);
      all(socket, sense, true);
    }
  });
  const int socket = ::accept(listener, nullptr, nullptr);
  ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
  double began_s = 0;
  for (int n = -kWarmUp; n < kExchanges; ++n) {
    if (n == 0) began_s = link::steady_s();
    all(socket, act, true);
    all(socket, sense, false);
  }
  const double us = (link::steady_s() - began_s) * 1e6 / kExchanges;
  ::close(socket);
  ::close(listener);
  return us;
}

/// A thousand connections at once, again and again: some say nothing, some a byte, some announce a giant.
void storm(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  for (;;) {
    std::vector<int> sockets;
    for (int n = 0; n < 1000; ++n) {
      const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
      if (socket < 0) break;
      sockets.push_back(socket);
      if (::connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) continue;
      const char giant[] = {0x7F, 0, 0, 0};
      const ssize_t ignored =
          n % 3 == 0 ? 0 : ::send(socket, n % 3 == 1 ? "{" : giant, n % 3 == 1 ? 1 : 4, MSG_NOSIGNAL);
      if (ignored < 0) continue;
    }
    ::usleep(200'000);
    for (const int socket : sockets) ::close(socket);
  }
}

/// Periods of a loop of 100 Hz [ms], as they really were, farthest from 10 first.
std::vector<double> jitters_ms(bool stormy, double& slowest_ms) {
  constexpr double kPeriod_s = 0.01;
  Linked linked(1);
  const Child strangers([&] {
    if (stormy) storm(linked.port());
    ::pause();
  });
  std::vector<double> jitters;
  slowest_ms = 0;
  double due_s = link::steady_s(), last_s = due_s;
  for (int n = 0; n < 500; ++n) {
    due_s += kPeriod_s;
    ::usleep(static_cast<useconds_t>(std::max(0.0, due_s - link::steady_s()) * 1e6));
    const double asked_s = link::steady_s();
    linked.exchange();
    const double now_s = link::steady_s();
    slowest_ms = std::max(slowest_ms, (now_s - asked_s) * 1e3);
    if (n > 0) jitters.push_back(std::fabs(now_s - last_s - kPeriod_s) * 1e3);
    last_s = now_s;
  }
  std::sort(jitters.rbegin(), jitters.rend());
  return linked.alive() ? jitters : std::vector<double>(500, NAN);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<Row> rows;
  struct Case {
    const char* name;
    int robots;
    link::Encoding encoding;
  };
  for (const Case one : {Case{"link/binary_1_robot", 1, link::Encoding::Binary},
                         Case{"link/binary_100_robots", 100, link::Encoding::Binary},
                         Case{"link/json_1_robot", 1, link::Encoding::Json}}) {
    const Sizes sizes = sizes_of(one.robots, one.encoding);
    rows.push_back(measured(
        one.name, "us", [&] { return us_per_exchange(one.robots, one.encoding); },
        [&] { return std::optional(us_per_ping_pong(sizes)); }));
    rows.push_back(
        {std::string(one.name) + "/bytes", static_cast<double>(sizes.act + sizes.sense), std::nullopt, "bytes"});
  }
  for (const bool stormy : {false, true}) {
    double slowest_ms = 0;
    const std::vector<double> jitters = jitters_ms(stormy, slowest_ms);
    const std::string name = stormy ? "link/loop_in_storm" : "link/loop_in_calm";
    rows.push_back({name + "/worst_period_off", jitters[0], std::nullopt, "ms"});
    rows.push_back({name + "/99_percent_off", jitters[5], std::nullopt, "ms"});
    rows.push_back({name + "/slowest_exchange", slowest_ms, std::nullopt, "ms"});
  }
  return print(
      rows, argc, argv,
      "Wall time of one exchange; rival: bare TCP ping-pong of as many bytes. Storm: 1,000 connections at once.\n");
}
