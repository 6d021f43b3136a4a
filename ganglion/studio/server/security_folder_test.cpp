#include "ganglion/base/file.h"
#include "ganglion/studio/server/testing/bench.h"

// What those who are let in cannot reach: files elsewhere, programs, the page itself.
namespace ganglion::studio {
namespace {

using Security = ServerTest;

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

TEST_F(Security, RecordsNoRunElsewhereWhenALinkTakesItsFoldersPlace) {
  const Client client = client_of();
  Watcher watcher(client);
  const Json paused = {{"experiment", "experiment.toml"}, {"duration_s", 1}, {"pace", 0}, {"paused", true}};
  ASSERT_EQ(client.post("/api/run/start", paused).status, 200u);
  std::filesystem::rename(folder() / "runs", folder() / "moved");
  std::filesystem::create_directory_symlink(outside(), folder() / "runs");
  client.post("/api/run/resume", {});
  Json state;
  while (state["state"] != "done") state = watcher.event("run", 60).value()["state"];
  EXPECT_TRUE(state["outcome"]["error"].is_null()) << state.dump();
  EXPECT_TRUE(state["outcome"]["file"].get<std::string>().starts_with("runs/")) << state.dump();
  EXPECT_TRUE(std::filesystem::is_empty(outside()));
  EXPECT_FALSE(std::filesystem::is_empty(folder() / "moved"));
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

}  // namespace
}  // namespace ganglion::studio
