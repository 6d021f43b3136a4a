#include <sys/resource.h>

#include <algorithm>

#include "ganglion/studio/server/testing/bench.h"

// What cannot wear the server out or end it: bodies, connections, viewers without end, and no HTTP at all.
namespace ganglion::studio {
namespace {

using Security = ServerTest;

TEST_F(Security, RefusesBodiesAndHeadersThatAreTooLarge) {
  const Client client = client_of();
  const std::string host = "127.0.0.1:" + std::to_string(client.port);
  const std::string head = "POST /api/document/open HTTP/1.1\r\nHost: " + host + "\r\nOrigin: http://" + host +
                           "\r\nAuthorization: Bearer " + client.token + "\r\n";
  EXPECT_EQ(talk(client.port, head + "Content-Length: 99999999999\r\n\r\n").status, 413u);
  EXPECT_EQ(client.send("POST", "/api/document/open", std::string((8 << 20) + 1, ' ')).status, 413u);
  std::string chunked = head + "Transfer-Encoding: chunked\r\n\r\n";
  for (int i = 0; i < 9; ++i) chunked += "100000\r\n" + std::string(1 << 20, ' ') + "\r\n";
  EXPECT_EQ(talk(client.port, chunked + "0\r\n\r\n").status, 413u);
  EXPECT_EQ(talk(client.port, head + "X: " + std::string(20'000, 'x') + "\r\n\r\n").status, 431u);
}

TEST_F(Security, TakesNoBodyWhoseEndItDoesNotKnow) {
  const Client client = client_of();
  const std::string head = "POST /api/file/open HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(client.port) +
                           "\r\nAuthorization: Bearer " + client.token + "\r\nTransfer-Encoding: ";
  EXPECT_EQ(talk(client.port, head + "gzip, chunked\r\n\r\n0\r\n\r\n").status, 501u);
  EXPECT_EQ(talk(client.port, head + "xchunked\r\n\r\n0\r\n\r\n").status, 501u);
  EXPECT_EQ(talk(client.port, head + "chunked\r\n\r\n0\r\n\r\n").status, 404u) << "a whole request, of no file";
}

TEST_F(Security, DropsAViewerThatSendsTooLargeAFrame) {
  const Client client = client_of();
  Watcher watcher(client);
  ASSERT_EQ(watcher.status(), 101u);
  ASSERT_TRUE(watcher.next());
  watcher.send(std::string((64 << 10) + 1, 'x'));
  EXPECT_TRUE(watcher.ended_within(20));
  EXPECT_EQ(client.get("/").status, 200u) << "and goes on serving";
}

TEST_F(Security, AnswersWhileAThousandSlowConnectionsHang) {
  rlimit limit{};
  ::getrlimit(RLIMIT_NOFILE, &limit);
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, 4096);
  ::setrlimit(RLIMIT_NOFILE, &limit);
  const Client client = client_of();
  Watcher watcher(client);
  ASSERT_TRUE(watcher.next());
  std::vector<RawConnection> slow;
  for (int i = 0; i < 1000; ++i) {
    slow.emplace_back(client.port);
    slow.back().write("GET / HTTP/1.1\r\nHost: 127");
  }
  for (int i = 0; i < 20; ++i) EXPECT_EQ(client.get("/").status, 200u);
  EXPECT_TRUE(slow.front().closed_within(5)) << "the oldest made room";
  EXPECT_EQ(client.post("/api/file/save", {{"path", "new.toml"}, {"text", ""}, {"based_on", ""}}).status, 200u);
  EXPECT_TRUE(watcher.event("file")) << "and who watches still does";
}

TEST_F(Security, LetsNoMoreThan64Watch) {
  const Client client = client_of();
  std::vector<std::unique_ptr<Watcher>> watchers;
  for (int i = 0; i < 64; ++i) {
    watchers.push_back(std::make_unique<Watcher>(client));
    ASSERT_EQ(watchers.back()->status(), 101u) << i;
  }
  EXPECT_EQ(Watcher(client).status(), 503u);
  EXPECT_EQ(client.get("/").status, 200u);
  watchers.clear();
  EXPECT_EQ(client.get("/").status, 200u);
}

TEST_F(Security, EndsAConnectionThatTricklesItsHeader) {
  const Client client = client_of();
  RawConnection slow(client.port);
  slow.write("GET / HTTP/1.1\r\n");
  EXPECT_TRUE(slow.closed_within(15));
}

TEST_F(Security, SurvivesWhatIsNoHttp) {
  const Client client = client_of();
  for (const std::string& bytes :
       {std::string("\0\0\0\0\r\n\r\n", 8), std::string("GET\r\n\r\n"), std::string(70'000, 'A'),
        std::string("\x16\x03\x01\x02\x00"), std::string("GET / HTTP/9.9\r\n\r\n")}) {
    RawConnection(client.port).write(bytes);
    EXPECT_EQ(client.get("/").status, 200u);
  }
  for (const char* body :
       {"", "[", "[1]", "null", "{\"path\":3}", "{\"path\":{}}", "{\"operations\":7,\"path\":\"controller.toml\"}"}) {
    for (const char* path : {"/api/file/open", "/api/file/save", "/api/document/edit", "/api/document/copy",
                             "/api/run/start", "/api/document/targets", "/api/run/pace", "/api/recording/samples"}) {
      const Answer answer = client.send("POST", path, body);
      EXPECT_TRUE(answer.status >= 200 && answer.status < 500) << path << " " << body << " " << answer.status;
    }
  }
}

}  // namespace
}  // namespace ganglion::studio
