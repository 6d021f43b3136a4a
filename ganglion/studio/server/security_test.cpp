#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>

#include "ganglion/base/file.h"
#include "ganglion/studio/server/guard.h"
#include "ganglion/studio/server/testing/bench.h"

// Every line of the studio's security, each against the real server on a real socket.
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

TEST_F(Security, ReadsAndWritesBelowItsFolderOnly) {
  const Client client = client_of();
  ASSERT_TRUE(write_file(outside() / "secret.toml", "secret = 1\n"));
  std::filesystem::create_symlink(outside(), folder() / "link");
  std::filesystem::create_symlink(outside() / "secret.toml", folder() / "linked.toml");
  ASSERT_TRUE(write_file(outside() / "drawing.toml", "name = \"a secret drawing\"\n[[acting]]\nid = \"a\"\n"));
  std::filesystem::create_symlink(outside() / "drawing.toml", folder() / "drawing.toml");
  for (const std::string& path :
       {std::string("../outside/secret.toml"), std::string("link/secret.toml"), std::string("linked.toml"),
        std::string("./controller.toml"), (outside() / "secret.toml").string(),
        std::string("a/../../outside/secret.toml"), std::string("..\\outside\\secret.toml"),
        std::string("controller.toml\0.toml", 20), std::string(".hidden.toml"), std::string("")}) {
    EXPECT_EQ(client.post("/api/file/open", {{"path", path}}).status, 404u) << path;
    EXPECT_EQ(client.post("/api/file/save", {{"path", path}, {"text", "x = 1"}, {"based_on", ""}}).status, 404u)
        << path;
    EXPECT_EQ(client.post("/api/file/autosave", {{"path", path}, {"text", "x = 1"}, {"based_on", ""}}).status, 404u)
        << path;
    EXPECT_EQ(client.post("/api/document/open", {{"path", path}, {"text", ""}}).status, 404u) << path;
    EXPECT_EQ(client.post("/api/run/start", {{"experiment", path}}).status, 404u) << path;
    EXPECT_EQ(client.post("/api/recording/open", {{"path", path}}).status, 404u) << path;
  }
  EXPECT_EQ(read_file(outside() / "secret.toml").value(), "secret = 1\n");
  for (const char* target : {"/../outside/secret.toml", "/%2e%2e/outside/secret.toml", "/..%2foutside%2fsecret.toml",
                             "/link/secret.toml", "/api/recording/report?path=..%2foutside%2fsecret.toml"}) {
    const Answer answer = client.get(target);
    EXPECT_EQ(answer.body.find("secret = 1"), std::string::npos) << target;
    EXPECT_EQ(answer.status, 404u) << target;
  }
  EXPECT_EQ(client.get("/api/files").body.find("secret"), std::string::npos);
}

TEST_F(Security, RunsNoExperimentThatNamesFilesElsewhere) {
  const Client client = client_of();
  ASSERT_TRUE(write_file(outside() / "robot.toml", "this is a secret, and no robot"));
  std::string text = read_file(folder() / "experiment.toml").value();
  text.replace(text.find("\"robot.toml\""), 12, "\"../outside/robot.toml\"");
  ASSERT_TRUE(write_file(folder() / "elsewhere.toml", text));
  const Answer answer = client.post("/api/run/start", {{"experiment", "elsewhere.toml"}});
  EXPECT_EQ(answer.status, 403u) << "refused before anything of it is read";
  EXPECT_EQ(answer.json()["error"]["code"], "Outside");
}

TEST_F(Security, RunsInNoMapThatLiesElsewhere) {
  const Client client = client_of();
  std::string image = "P2\n200 200\n255\n";
  for (int i = 0; i < 200 * 200; ++i) image += "254\n";
  const std::string yaml =
      "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  const auto start = [&](const std::filesystem::path& where, const std::string& map) {
    EXPECT_TRUE(write_file(where / "map.pgm", image));
    EXPECT_TRUE(write_file(where / "map.yaml", yaml));
    EXPECT_TRUE(write_file(folder() / "mapped.toml", "format = 1\nmap = \"" + map + "\"\n"));
    return client.post("/api/run/start",
                       {{"experiment", "experiment.toml"}, {"world", "mapped.toml"}, {"paused", true}});
  };
  const Answer outside_it = start(outside(), "../outside/map.yaml");
  EXPECT_EQ(outside_it.status, 403u) << outside_it.body;
  const Answer inside_it = start(folder(), "map.yaml");
  EXPECT_EQ(inside_it.status, 200u) << inside_it.body;
}

TEST_F(Security, RecordsNoRunElsewhere) {
  std::filesystem::create_symlink(outside(), folder() / "runs");
  const Client client = client_of();
  EXPECT_EQ(client.post("/api/run/start", {{"experiment", "experiment.toml"}, {"duration_s", 1}}).status, 404u);
  EXPECT_TRUE(std::filesystem::is_empty(outside()));
}

TEST_F(Security, ServesAWebRootWithoutLeavingIt) {
  ASSERT_TRUE(write_file(outside() / "web/index.html", "<p>page"));
  ASSERT_TRUE(write_file(outside() / "secret.js", "secret"));
  const Client client = client_of({.web_root = outside() / "web"});
  EXPECT_EQ(client.get("/").body, "<p>page");
  for (const char* target : {"/../secret.js", "/%2e%2e/secret.js", "//secret.js", "/x/../../secret.js"}) {
    EXPECT_EQ(client.get(target).status, 404u) << target;
  }
}

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

TEST_F(Security, KeepsScriptsInNamesText) {
  const Client client = client_of();
  const std::string script = "<script>alert(1)</script>";
  const std::string text = "format = 1\nname = \"" + script + "\"\nrobot = \"robot.toml\"\n[[acting]]\nid = \"" +
                           script + "\"\nkind = \"" + script + "\"\n";
  const Answer opened = client.post("/api/document/open", {{"path", "controller.toml"}, {"text", text}});
  EXPECT_EQ(opened.header("content-type"), "application/json");
  EXPECT_EQ(opened.header("x-content-type-options"), "nosniff");
  EXPECT_EQ(opened.json()["model"]["components"][0]["id"], script) << "as text it comes through whole";
  const Answer edited =
      client.post("/api/document/edit",
                  {{"path", "controller.toml"},
                   {"text", text},
                   {"operations", {{{"op", "rename"}, {"id", script}, {"to", "\"><img src=x onerror=alert(1)>"}}}}});
  EXPECT_EQ(edited.status, 400u);
  for (const char* target :
       {"/<script>alert(1)</script>", "/api/<script>", "/api/recording/report?path=<script>alert(1)</script>"}) {
    const Answer answer = client.get(target);
    EXPECT_FALSE(answer.header("content-type").starts_with("text/html") &&
                 answer.body.find("<script>alert") != std::string::npos);
  }
}

TEST_F(Security, StartsNoProgramThatIsNotOnTheUsersList) {
  const std::filesystem::path list = outside() / "studio.toml";
  ASSERT_TRUE(write_file(list, "format = 1\n[[program]]\nname = \"mine\"\ncommand = [\"/bin/true\", \"{port}\"]\n"));
  const Client client = client_of({.programs = list});
  EXPECT_EQ(client.get("/api/programs").json()["programs"][0]["name"], "mine");
  EXPECT_EQ(client.get("/api/programs").body.find("/bin/true"), std::string::npos);
  const std::filesystem::path mark = outside() / "ran";
  for (const std::string& program : {std::string("/bin/touch"), "touch " + mark.string(), std::string("")}) {
    const Answer answer = client.post("/api/run/start", {{"experiment", "experiment.toml"}, {"program", program}});
    EXPECT_EQ(answer.status, 403u) << program;
    EXPECT_EQ(answer.json()["error"]["code"], "ProgramNotListed");
  }
  for (const char* key : {"controller", "application.robot", "application.world", "application.program",
                          "application.address", "application"}) {
    const std::string set = std::string(key) + "={program = [\"/bin/touch\", \"" + mark.string() + "\"]}";
    EXPECT_EQ(
        client.post("/api/run/start", {{"experiment", "experiment.toml"}, {"set", {set}}}).json()["error"]["code"],
        "Forbidden")
        << key;
  }
  const std::string command = "application.program=[\"/bin/touch\", \"" + mark.string() + "\"]";
  EXPECT_EQ(client.post("/api/run/start", {{"experiment", "experiment.toml"}, {"set", {command}}}).status, 403u);
  const std::string experiment = read_file(folder() / "experiment.toml").value();
  const std::string bad = "[application]\nprogram = [\"/bin/touch\", \"" + mark.string() + "\"]\n" +
                          experiment.substr(experiment.find('\n', experiment.find("[application]")) + 1);
  const std::string text = experiment.substr(0, experiment.find("[application]")) + bad;
  ASSERT_EQ(client.post("/api/file/save", {{"path", "bad.toml"}, {"text", text}, {"based_on", ""}}).status, 200u);
  const Answer written = client.post("/api/run/start", {{"experiment", "bad.toml"}});
  EXPECT_EQ(written.status, 403u) << written.body;
  EXPECT_EQ(
      client.post("/api/run/start", {{"experiment", "experiment.toml"}, {"address", "serial:///etc/passwd"}}).status,
      403u);
  EXPECT_FALSE(std::filesystem::exists(mark));
}

TEST_F(Security, ListensForThisMachineUnlessToldOtherwise) {
  const Client client = client_of();
  EXPECT_TRUE(RawConnection(client.port).is_open());
  EXPECT_FALSE(RawConnection(client.port, "127.0.0.2").is_open()) << "bound to more than 127.0.0.1";
}

TEST_F(Security, ListensForOthersOnlyWhereANameIsGiven) {
  const auto open = Server::start({.folder = folder(), .address = "0.0.0.0"});
  ASSERT_FALSE(open);
  EXPECT_NE(open.error().message.find("--allow-host"), std::string::npos);
  const auto named = Server::start({.folder = folder(), .address = "0.0.0.0", .allow_hosts = {"robot.local"}});
  ASSERT_TRUE(named);
  Client client{(*named)->port(), (*named)->token(), {}};
  EXPECT_TRUE(RawConnection(client.port, "127.0.0.2").is_open()) << "others reach it, as was asked for";
  client.headers["Host"] = "robot.local:" + std::to_string(client.port);
  EXPECT_EQ(client.get("/").status, 200u);
  client.headers["Host"] = "other.local:" + std::to_string(client.port);
  EXPECT_EQ(client.get("/").status, 421u);
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
