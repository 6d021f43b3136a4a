#include "ganglion/base/file.h"
#include "ganglion/studio/server/testing/bench.h"

// Whoever asks in Spanish is answered in Spanish.
namespace ganglion::studio {
namespace {

class Speaking : public ServerTest {
 protected:
  void SetUp() override {
    ServerTest::SetUp();
    text_ = read_file(folder() / "controller.toml").value();
  }
  std::string with(std::string_view old, std::string_view by) const {
    std::string text = text_;
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return at == std::string::npos ? text : text.replace(at, old.size(), by);
  }
  static Json problems(const Client& client, const std::string& text, const char* language) {
    const Json body = {{"path", "controller.toml"}, {"text", text}, {"language", language}};
    return client.post("/api/document/open", body).json()["model"]["problems"];
  }
  static std::string message(const Answer& answer) { return answer.json()["error"]["message"]; }
  const std::string& text() const noexcept { return text_; }

 private:
  std::string text_;
};

constexpr std::string_view kLeft = "in.left = \"clear_left.range\"", kRange = "trigger_range_m = 0.10",
                           kAll = "[\"escape\", \"avoid\", \"hold\"]";

TEST_F(Speaking, SaysInBothLanguagesWhatIsWrongWithABrokenDrawing) {
  constexpr std::pair<std::string_view, std::string_view> kSlips[] = {
      {"format = 1\n", ""},
      {"robot = \"robot.toml\"", "robot = \"robto.toml\""},
      {"channel = \"compass.heading\"", "channel = \"compass.headin\""},
      {"kind = \"Escape\"", "kind = \"Escpe\""},
      {"kind = \"Escape\"", ""},
      {kLeft, ""},
      {kLeft, "in.lef = \"clear_left.range\""},
      {kLeft, "in.left = \"sonar_lft\""},
      {kLeft, "in.left = \"heading\""},
      {kLeft, "in.left = \"clear_left.rnge\""},
      {kLeft, "in.left = \"sonar_left.range\""},
      {kLeft, "in.left = [\"sonar_left\", \"sonar_right\"]"},
      {kLeft, "left = \"clear_left.range\""},
      {kRange, "trigger_range_m = \"0.10\""},
      {kRange, "trigger_range_m = -1"},
      {kRange, "triger_range_m = 0.1"},
      {"command = \"drive\"", "command = \"drve\""},
      {"command = \"drive\"", ""},
      {kAll, "[\"escape\", \"avoid\", \"heading\"]"},
      {kAll, "[\"escape\", \"avoid\"]"},
      {kAll, "[\"escape\", \"avoid\", \"hold\", \"avoid\"]"},
      {"id = \"avoid\"", "id = \"escape\""},
      {"id = \"avoid\"", "id = \"1avoid\""},
      {"id = \"avoid\"", ""},
      {"readings = 1", "readings = 1.5"},
      {"readings = 1", "readings = "},
  };
  const Client client = client_of();
  for (const auto& [old, by] : kSlips) {
    const std::string broken = with(old, by);
    const Json english = problems(client, broken, "en"), spanish = problems(client, broken, "es");
    ASSERT_FALSE(english.empty()) << old << " -> " << by;
    ASSERT_EQ(english.size(), spanish.size());
    for (std::size_t i = 0; i < english.size(); ++i) {
      EXPECT_EQ(english[i]["line"], spanish[i]["line"]);
      EXPECT_EQ(english[i]["subject"], spanish[i]["subject"]);
      EXPECT_NE(english[i]["message"], spanish[i]["message"]);
      EXPECT_FALSE(spanish[i]["message"].get<std::string>().empty()) << english[i];
    }
  }
}

TEST_F(Speaking, PutsWhatDiffersWhereItBelongs) {
  const Client client = client_of();
  const auto first = [&](std::string_view old, std::string_view by) {
    return problems(client, with(old, by), "es")[0]["message"].get<std::string>();
  };
  const std::string range = first(kRange, "trigger_range_m = -1");
  EXPECT_TRUE(range.starts_with("escape: trigger_range_m es -1, debe ")) << range;
  EXPECT_EQ(first(kRange, "trigger_range_m = \"0.10\""), "escape: trigger_range_m es un texto, debe ser un número");
  EXPECT_EQ(first("kind = \"Escape\"", "kind = \"Escpe\""),
            "escape: \"Escpe\" no es un tipo de módulo de actuación; ¿quiso decir \"Escape\"?");
  const std::string unit = first("in.heading = \"heading\"\nin.side", "in.heading = \"sonar_left\"\nin.side");
  EXPECT_TRUE(unit.starts_with("escape: la entrada \"heading\" está en [rad], \"sonar_left\" está en [m]")) << unit;
}

TEST_F(Speaking, SaysWhyNotInTheLanguageThatWasAskedFor) {
  const Client client = client_of();
  Json body = {{"path", "controller.toml"}, {"text", text()}, {"from", "nobody"}, {"to", "escape"}, {"port", "left"}};
  const auto reason = [&] { return client.post("/api/document/may_connect", body).json()["reasons"][0]; };
  EXPECT_TRUE(reason().get<std::string>().starts_with("\"nobody\" is no sensation or module")) << reason();
  body["language"] = "es";
  EXPECT_TRUE(reason().get<std::string>().starts_with("\"nobody\" no es una sensación ni un módulo")) << reason();
}

TEST_F(Speaking, RefusesInTheLanguageThatWasAskedFor) {
  const Client client = client_of();
  const Json nowhere = {{"path", "nowhere.toml"}, {"language", "es"}};
  EXPECT_EQ(message(client.post("/api/file/open", nowhere)), "\"nowhere.toml\": no existe el archivo");
  EXPECT_EQ(message(client.post("/api/run/pause", {{"language", "es"}})), "no hay ninguna ejecución");
  EXPECT_EQ(message(client.post("/api/run/pause", {})), "no run is on");
  const Json edit = {{"path", "controller.toml"},
                     {"text", text()},
                     {"operations", {{{"op", "rename"}, {"id", "escpe"}, {"to", "x"}}}},
                     {"language", "es"}};
  EXPECT_EQ(message(client.post("/api/document/edit", edit)),
            "no hay ningún componente \"escpe\"; ¿quiso decir \"escape\"?");
}

TEST_F(Speaking, TakesTheBrowsersLanguageWhereNobodyNamesOne) {
  Client client = client_of();
  for (const char* spanish : {"es", "es-ES,es;q=0.9,en;q=0.5"}) {
    client.headers["Accept-Language"] = spanish;
    EXPECT_EQ(message(client.get("/api/nowhere")), "aquí no hay nada") << spanish;
    EXPECT_EQ(message(client.post("/api/run/pause", {})), "no hay ninguna ejecución") << spanish;
    EXPECT_EQ(message(client.post("/api/run/pause", {{"language", "en"}})), "no run is on") << spanish;
  }
  client.headers["Accept-Language"] = "en-GB,es;q=0.9";
  EXPECT_EQ(message(client.get("/api/nowhere")), "there is nothing at this path");
}

TEST_F(Speaking, TellsOfAProblemWhatItIsAboutAndWhatWouldHaveBeenRight) {
  const Client client = client_of();
  const Json kind = problems(client, with("kind = \"Escape\"", "kind = \"Escpe\""), "en")[0]["subject"];
  EXPECT_EQ(kind["component"], "escape");
  EXPECT_EQ(kind["part"], "kind");
  EXPECT_EQ(kind["found"], "Escpe");
  EXPECT_EQ(kind["choices"][0], "Escape") << "the nearest first";
  const Json wire = problems(client, with(kLeft, "in.left = \"sonar_lft\""), "en")[0]["subject"];
  EXPECT_EQ(wire["part"], "in.left");
  EXPECT_EQ(wire["found"], "sonar_lft");
  const Json missing = problems(client, with(kLeft, ""), "en")[0];
  EXPECT_EQ(missing["subject"]["part"], "in.left");
  EXPECT_EQ(missing["port"], "left");
}

}  // namespace
}  // namespace ganglion::studio
