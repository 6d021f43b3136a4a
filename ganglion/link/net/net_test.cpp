#include <gtest/gtest.h>
#include <unistd.h>

#include <thread>

#include "ganglion/base/file.h"
#include "ganglion/link/net/lines.h"
#include "ganglion/link/net/program.h"
#include "ganglion/link/net/proxy.h"
#include "ganglion/link/net/server.h"
#include "ganglion/link/net/testing/serving.h"
#include "ganglion/link/testing/bench.h"

namespace ganglion::link {
namespace {

namespace fs = std::filesystem;

TEST(Address, IsReadAsPeopleWriteIt) {
  EXPECT_EQ(parse_address("tcp://127.0.0.1:7007")->host, "127.0.0.1");
  EXPECT_EQ(parse_address("robot.local:7007")->text, "tcp://robot.local:7007");
  EXPECT_EQ(parse_address("tcp://[::1]:80")->host, "::1");
  EXPECT_EQ(parse_address("tcp://[::1]:80")->text, "tcp://[::1]:80");
  EXPECT_EQ(parse_address("::1:80")->text, "tcp://[::1]:80") << "to be typed back";
  EXPECT_EQ(parse_address("serial:///dev/ttyUSB0?baud=9600")->baud, 9600u);
  EXPECT_EQ(parse_address("serial:///dev/ttyACM0")->baud, 115'200u);
  EXPECT_EQ(make_line(*parse_address("serial+tcp://127.0.0.1:7007"))->carrier(), Carrier::Packets);
  EXPECT_EQ(make_line(*parse_address("tcp://127.0.0.1:7007"))->carrier(), Carrier::Stream);
  for (const char* wrong :
       {"", "robot", ":7007", "tcp://a:70000", "tcp://a:", "http://a:80", "tcp://a/b:80", "tcp://a b:80", "a@b:80",
        "tcp://a\n:80", "serial://ttyUSB0", "serial:///dev/x?speed=1", "serial:///dev/x?baud=0"}) {
    EXPECT_FALSE(parse_address(wrong)) << wrong;
  }
}

/// A robot that listens on a port of this machine, served by a thread of its own.
class Served {
 public:
  Served() : end_(robot_, config()), serving_(end_) {}
  void stop() { serving_.stop(); }
  const Address& address() const { return serving_.address(); }
  std::unique_ptr<Line> line() const { return make_line(serving_.address()); }
  NotebookRobot& robot() { return robot_; }

 private:
  static RobotEndConfig config() {
    RobotEndConfig config;
    config.token = random_token;
    config.handshake_s = 60;
    return config;
  }
  NotebookRobot robot_;
  RobotEnd end_;
  Serving serving_;
};

TEST(Server, CarriesASessionOverTcp) {
  NotebookRobot alone;
  const auto expected = drive(alone, 300);
  for (const Encoding encoding : {Encoding::Binary, Encoding::Json}) {
    Served served;
    RemoteConfig config;
    config.end.encoding = encoding;
    auto remote = RemoteApplication::connect(served.line(), served.robot().description(), 1, config);
    ASSERT_TRUE(remote) << remote.error().what.en;
    EXPECT_EQ(drive(**remote, 300).size(), expected.size());
    remote->reset();
    served.stop();
    EXPECT_EQ(served.robot().done(), alone.done());
  }
}

/// What a connection hears until it is closed, or nothing comes for half a minute: this machine may be busy.
std::string heard(Line& line) {
  std::string all;
  std::vector<char> room(4096);
  for (;;) {
    const auto got = line.receive(room, line.now_s() + 30);
    if (!got || *got == 0) return all;
    all.append(room.data(), *got);
  }
}

TEST(Server, TellsManyStrangersWhyAndGoesOn) {
  Served served;
  const auto remote = RemoteApplication::connect(served.line(), served.robot().description(), 1, {});
  ASSERT_TRUE(remote) << remote.error().what.en;
  std::vector<std::unique_ptr<Line>> strangers;
  for (int n = 0; n < 400; ++n) {  // more than may connect; descriptors of both ends are in this process
    strangers.push_back(served.line());
    ASSERT_TRUE(strangers.back()->connect(steady_s() + 5));
  }
  EXPECT_TRUE(strangers[0]->send(std::string("\0\x7F\xFF\xFF", 4), steady_s() + 1));
  EXPECT_EQ(drive(**remote, 50).size() % 50, 0u);
  EXPECT_EQ((*remote)->failure(), nullptr);
  EXPECT_NE(heard(*strangers[0]).find("announces 8388607 bytes; the limit is 4096"), std::string::npos);
  EXPECT_NE(heard(*strangers[399]).find("no more than 256 connections"), std::string::npos);
}

TEST(Server, SaysGoodbyeWhenItEnds) {
  Served served;
  const auto remote = RemoteApplication::connect(served.line(), served.robot().description(), 1, {});
  ASSERT_TRUE(remote);
  drive(**remote, 10);
  served.stop();
  const std::vector<ActFrame> act = {make_act_frame((*remote)->description())};
  (*remote)->step(act, 0.1);
  ASSERT_NE((*remote)->failure(), nullptr);
  EXPECT_NE((*remote)->failure()->what.en.find("the robot said goodbye: the test is over"), std::string::npos);
  EXPECT_NE((*remote)->failure()->what.es.find("el robot se despidió: la prueba terminó"), std::string::npos);
}

/// A proxy on a port of this machine, served by a thread of its own.
class Proxied {
 public:
  Proxied(const Address& to, const char* faults, std::uint64_t seed) {
    auto proxy = Proxy::listen({*parse_address("127.0.0.1:0"), to, *parse_line_faults(faults), seed,
                                [this](const Sentence& line) { log_ += line.en + "\n"; }});
    EXPECT_TRUE(proxy) << proxy.error().what.en;
    proxy_ = std::move(*proxy);
    thread_ =
        std::jthread([this](const std::stop_token& stop) { proxy_->serve([&] { return stop.stop_requested(); }); });
  }
  ~Proxied() { log(); }
  std::unique_ptr<Line> line() const { return make_line(proxy_->address()); }
  /// Once it has ended.
  const std::string& log() {
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
    return log_;
  }

 private:
  std::string log_;
  std::unique_ptr<Proxy> proxy_;
  std::jthread thread_;
};

TEST(Proxy, LetsASessionThroughItsFaultsToTheSameEnd) {
  NotebookRobot alone;
  drive(alone, 200);
  Served served;
  Proxied proxied(served.address(), "delay=1ms,jitter=1ms,merge=2%,split=30%; fin=1%,rst=1%", 3);
  auto remote = RemoteApplication::connect(proxied.line(), served.robot().description(), 1, {});
  ASSERT_TRUE(remote) << remote.error().what.en;
  drive(**remote, 200);
  EXPECT_EQ((*remote)->failure(), nullptr);
  EXPECT_GT((*remote)->statistics().reconnections, 0u);
  remote->reset();
  served.stop();
  EXPECT_EQ(served.robot().done(), alone.done());
  EXPECT_NE(proxied.log().find("connection 1 "), std::string::npos);
  EXPECT_NE(proxied.log().find(" split"), std::string::npos);
}

TEST(Proxy, PassesWhatIsNoLink) {
  Served served;
  Proxied proxied(served.address(), "none", 0);
  const auto line = proxied.line();
  ASSERT_TRUE(line->connect(steady_s() + 5));
  ASSERT_TRUE(line->send("GET / HTTP/1.1\r\n", steady_s() + 5));
  EXPECT_NE(heard(*line).find("this is a Ganglion robot link"), std::string::npos);
}

TEST(Proxy, ClosesWhereThereIsNoRobot) {
  Proxied proxied(*parse_address(fmt::format("127.0.0.1:{}", free_port().value())), "none", 0);
  const auto line = proxied.line();
  ASSERT_TRUE(line->connect(steady_s() + 5));
  std::vector<char> room(10);
  EXPECT_FALSE(line->receive(room, steady_s() + 5));
  EXPECT_NE(proxied.log().find("connection 0: no robot at tcp://127.0.0.1:"), std::string::npos);
}

TEST(Proxy, GoesBetweenTcpAddressesOnly) {
  const auto proxy = Proxy::listen({*parse_address("127.0.0.1:0"), *parse_address("serial:///dev/ttyUSB0"), {}, 0, {}});
  ASSERT_FALSE(proxy);
  EXPECT_NE(proxy.error().what.en.find("write tcp://HOST:PORT"), std::string::npos);
}

TEST(TcpLine, SaysWhatToDoWhereNobodyListens) {
  const auto line = make_line(*parse_address(fmt::format("127.0.0.1:{}", free_port().value())));
  const auto reached = line->connect(steady_s() + 5);
  ASSERT_FALSE(reached);
  EXPECT_NE(reached.error().what.en.find("ganglion sim EXPERIMENT --listen"), std::string::npos);
}

TEST(Program, IsToldItsPortAndEndsWithItsOwner) {
  const fs::path output = fs::temp_directory_path() / fmt::format("ganglion_program_test_{}.log", ::getpid());
  fs::create_symlink("/nowhere/else", output);  // nobody's business
  {
    auto program = Program::start({"sh", "-c", "echo {port} $GANGLION_PORT; pwd; exec sleep 1000"}, "/", 4711, output);
    ASSERT_TRUE(program) << program.error().what.en;
    const double until_s = steady_s() + 10;
    while (program->last_words().en.find("| /") == std::string::npos && steady_s() < until_s) std::this_thread::yield();
    EXPECT_EQ(program->last_words(), Sentence::quoted("4711 4711 | /"));
    EXPECT_FALSE(program->ended());
    program->name_output(output);
  }
  EXPECT_EQ(*read_file(output), "4711 4711\n/\n");
  fs::remove(output);
  const auto missing = Program::start({"no-such-program-of-ours"}, "/", 1, output);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::NotFound);
}

}  // namespace
}  // namespace ganglion::link
