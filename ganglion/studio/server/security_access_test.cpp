#include "ganglion/studio/server/testing/bench.h"

// Who is let in, by which name and from which page: each against the real server on a real socket.
namespace ganglion::studio {
namespace {

using Security = ServerTest;

TEST_F(Security, LetsTheKeyInAndExchangesItForACookie) {
  Client client = client_of();
  client.headers["Authorization"] = "";
  const Answer first = client.get("/some/page?token=" + client.token + "&x=1");
  EXPECT_EQ(first.status, 303u);
  EXPECT_EQ(first.header("location"), "/some/page?x=1");
  const std::string cookie = first.header("set-cookie");
  EXPECT_TRUE(cookie.starts_with("ganglion_" + std::to_string(client.port) + "="));
  EXPECT_NE(cookie.find("HttpOnly; SameSite=Strict; Path=/"), std::string::npos);
  EXPECT_EQ(cookie.find(client.token), std::string::npos) << "the key itself is no cookie";
  client.headers["Cookie"] = cookie.substr(0, cookie.find(';'));
  EXPECT_EQ(client.get("/").status, 200u);
  EXPECT_EQ(client.post("/api/file/open", {{"path", "controller.toml"}}).status, 200u);
}

TEST_F(Security, WantsTheKeyForEveryPath) {
  Client client = client_of();
  for (const char* authorization : {"", "Bearer ", "Bearer 0", "Basic abc"}) {
    client.headers["Authorization"] = authorization;
    for (const char* path : {"/", "/index.html", "/api/files", "/api/kinds", "/nowhere", "/ws"}) {
      EXPECT_EQ(client.get(path).status, 401u) << path << " with " << authorization;
    }
    EXPECT_EQ(client.post("/api/run/start", {}).status, 401u);
    EXPECT_EQ(Watcher(client).status(), 401u);
  }
  client.headers["Cookie"] = "ganglion_" + std::to_string(client.port) + "=" + std::string(64, '0');
  EXPECT_EQ(client.get("/").status, 401u);
  EXPECT_EQ(client.get("/?token=" + std::string(64, '0')).status, 401u);
}

TEST_F(Security, AnswersToItsOwnNamesOnly) {
  Client client = client_of();
  const std::string port = std::to_string(client.port);
  for (const std::string& host :
       {std::string("evil.example:") + port, std::string("127.0.0.1"), std::string("127.0.0.1:1"),
        std::string("localhost.evil.example:") + port, std::string("127.0.0.1:") + port + ".x"}) {
    client.headers["Host"] = host;
    EXPECT_EQ(client.get("/").status, 421u) << host;
    EXPECT_EQ(Watcher(client).status(), 421u) << host;
  }
  client.headers["Host"] = "localhost:" + port;
  EXPECT_EQ(client.get("/").status, 200u);
  const std::string both = "GET / HTTP/1.1\r\nHost: 127.0.0.1:" + port +
                           "\r\nHost: evil.example\r\nAuthorization: Bearer " + client.token + "\r\n\r\n";
  EXPECT_EQ(talk(client.port, both).status, 421u);
  EXPECT_EQ(talk(client.port, "GET / HTTP/1.0\r\nAuthorization: Bearer " + client.token + "\r\n\r\n").status, 421u);
}

/// With the cookie a browser would send, and no token.
Client page_of(Client client) {
  client.headers["Authorization"] = "";
  const std::string cookie = client.get("/?token=" + client.token).header("set-cookie");
  client.headers["Cookie"] = cookie.substr(0, cookie.find(';'));
  return client;
}

/// Origins that are not that of the page of `port`.
std::vector<std::string> foreign_origins(std::uint16_t port) {
  const std::string own = std::to_string(port);
  return {"null",
          "http://evil.example",
          "http://127.0.0.1:" + std::to_string(port + 1),
          "https://127.0.0.1:" + own,
          "http://localhost:" + own,
          "http://127.0.0.1:" + own + "/",
          "http://127.0.0.1:" + own + ".evil.example"};
}

TEST_F(Security, TakesCommandsFromItsOwnPageOnly) {
  Client client = page_of(client_of());
  const std::string port = std::to_string(client.port);
  std::vector<std::string> origins = foreign_origins(client.port);
  origins.emplace_back();  // none
  for (const std::string& origin : origins) {
    client.headers["Origin"] = origin;
    EXPECT_EQ(client.post("/api/file/open", {{"path", "controller.toml"}}).status, 403u) << origin;
    EXPECT_EQ(client.send("PUT", "/api/files", "").status, 403u) << origin;
    EXPECT_EQ(client.send("OPTIONS", "/api/files", "").status, 403u) << origin;
    EXPECT_EQ(Watcher(client).status(), 403u) << origin;
  }
  client.headers["Origin"] = "http://127.0.0.1:" + port;
  EXPECT_EQ(client.post("/api/file/open", {{"path", "controller.toml"}}).status, 200u);
  EXPECT_EQ(Watcher(client).status(), 101u);
}

TEST_F(Security, LetsAScriptInThatNamesNoPage) {
  Client client = client_of();
  client.headers["Origin"] = "";
  EXPECT_EQ(client.post("/api/file/open", {{"path", "controller.toml"}}).status, 200u);
  EXPECT_EQ(Watcher(client).status(), 101u);
  const std::string bytes = "POST /api/file/open HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(client.port) +
                            "\r\nAuthorization: Bearer " + client.token + "\r\nOrigin:\r\nContent-Length: 2\r\n\r\n{}";
  EXPECT_EQ(talk(client.port, bytes).status, 403u) << "an empty Origin is one";
  for (const std::string& origin : foreign_origins(client.port)) {
    client.headers["Origin"] = origin;
    EXPECT_EQ(client.post("/api/file/open", {{"path", "controller.toml"}}).status, 403u) << origin;
    EXPECT_EQ(client.get("/api/files").status, 403u) << origin;
    EXPECT_EQ(Watcher(client).status(), 403u) << origin;
  }
  client.headers["Origin"] = "http://127.0.0.1:" + std::to_string(client.port);
  EXPECT_EQ(client.post("/api/file/open", {{"path", "controller.toml"}}).status, 200u);
  client.headers["Authorization"] = "Bearer " + std::string(64, '0');
  client.headers["Origin"] = "";
  EXPECT_EQ(client.post("/api/file/open", {{"path", "controller.toml"}}).status, 401u);
}

TEST_F(Security, ShowsNothingToThePageOfAnotherPort) {
  Client client = client_of();  // a browser sends the cookie there too: ports are one site
  client.headers["Sec-Fetch-Site"] = "same-site";
  EXPECT_EQ(client.get("/api/files").status, 403u);
  client.headers["Sec-Fetch-Site"] = "cross-site";
  EXPECT_EQ(client.get("/").status, 403u);
  client.headers["Sec-Fetch-Site"] = "same-origin";
  EXPECT_EQ(client.get("/api/files").status, 200u);
}

TEST_F(Security, SendsTheHeadersThatBindABrowserWithEveryAnswer) {
  const Client client = client_of();
  Client stranger = client;
  stranger.headers["Authorization"] = "";
  for (const Answer& answer : {client.get("/"), client.get("/api/files"), client.get("/nowhere.js"), stranger.get("/"),
                               client.post("/api/file/open", {}), client.get("/?token=" + client.token)}) {
    const std::string policy = answer.header("content-security-policy");
    EXPECT_TRUE(policy.starts_with("default-src 'self'; frame-ancestors 'none'")) << policy;
    EXPECT_EQ(policy.find("unsafe"), std::string::npos) << "neither eval nor scripts in the page";
    EXPECT_EQ(answer.header("referrer-policy"), "no-referrer") << "the key stands in the first URL";
    EXPECT_EQ(answer.header("cross-origin-resource-policy"), "same-origin");
    EXPECT_EQ(answer.header("cross-origin-opener-policy"), "same-origin");
    EXPECT_EQ(answer.header("x-content-type-options"), "nosniff");
    EXPECT_EQ(answer.header("cache-control"), "no-store");
    for (const auto& [name, value] : answer.headers) EXPECT_FALSE(name.starts_with("access-control")) << name;
  }
}

TEST_F(Security, ListensForThisMachineUnlessToldOtherwise) {
  const Client client = client_of();
  EXPECT_TRUE(RawConnection(client.port).is_open());
  EXPECT_FALSE(RawConnection(client.port, "127.0.0.2").is_open()) << "bound to more than 127.0.0.1";
}

TEST_F(Security, ListensForOthersOnlyWhereANameIsGiven) {
  const auto open = Server::start({.folder = folder(), .address = "0.0.0.0"});
  ASSERT_FALSE(open);
  EXPECT_NE(open.error().what.en.find("--allow-host"), std::string::npos);
  const auto named = Server::start({.folder = folder(), .address = "0.0.0.0", .allow_hosts = {"robot.local"}});
  ASSERT_TRUE(named);
  Client client{(*named)->port(), (*named)->token(), {}};
  EXPECT_TRUE(RawConnection(client.port, "127.0.0.2").is_open()) << "others reach it, as was asked for";
  client.headers["Host"] = "robot.local:" + std::to_string(client.port);
  EXPECT_EQ(client.get("/").status, 200u);
  client.headers["Host"] = "other.local:" + std::to_string(client.port);
  EXPECT_EQ(client.get("/").status, 421u);
}

}  // namespace
}  // namespace ganglion::studio
