#include "ganglion/studio/api/router.h"

#include <gtest/gtest.h>

namespace ganglion::studio {
namespace {

Router greeter() {
  Router router;
  router.get("/api/greeting", [](const Ask&) { return json_reply({{"greeting", "hello"}}); });
  router.post("/api/greet", [](const Ask& ask) {
    return json_reply({{"to", ask.body.at("to").get<std::string>()}, {"spanish", ask.language == Language::Spanish}});
  });
  return router;
}

Reply ask(const std::string& method, const std::string& path, const std::string& body = "") {
  return greeter().handle({method, path, path, body});
}

TEST(Router, AnswersByPathAndMethod) {
  EXPECT_EQ(ask("GET", "/api/greeting").body, R"({"greeting":"hello"})");
  EXPECT_EQ(ask("HEAD", "/api/greeting").status, 200u);
  EXPECT_EQ(ask("POST", "/api/greeting").status, 405u);
  EXPECT_EQ(ask("HEAD", "/api/greet").status, 405u);
  EXPECT_EQ(ask("GET", "/api/greeting/").status, 404u);
}

TEST(Router, TakesObjectsOnly) {
  EXPECT_EQ(ask("POST", "/api/greet", R"({"to":"you","language":"es"})").body, R"({"to":"you","spanish":true})");
  EXPECT_EQ(ask("POST", "/api/greet", "[1]").status, 400u);
  EXPECT_EQ(ask("POST", "/api/greet", "{").status, 400u);
}

TEST(Router, TellsWhatIsOfAnotherType) {
  for (const char* body : {R"({"to":3})", R"({})", ""}) {
    const Reply reply = ask("POST", "/api/greet", body);
    EXPECT_EQ(reply.status, 400u);
    EXPECT_EQ(parsed(reply.body)["error"]["code"], "BadRequest");
  }
}

}  // namespace
}  // namespace ganglion::studio
