#include "ganglion/studio/document/wording.h"

#include <gtest/gtest.h>

#include "ganglion/base/file.h"
#include "ganglion/studio/document/drawing.h"
#include "ganglion/studio/document/spanish.h"

namespace ganglion::studio {
namespace {

std::string spanish(std::string_view message) { return worded(message, Language::Spanish); }

TEST(Wording, PutsWhatDiffersWhereItBelongs) {
  EXPECT_EQ(spanish("hold: input \"heading\" is in [rad], \"sonar_left\" is in [m]; valid: heading"),
            "hold: la entrada \"heading\" está en [rad], \"sonar_left\" está en [m]; válidos: heading");
  EXPECT_EQ(spanish("\"escpe\" is no sensation or module; did you mean \"escape\"?"),
            "\"escpe\" no es una sensación ni un módulo; ¿quiso decir \"escape\"?");
  EXPECT_EQ(spanish("escape: trigger_range_m is a text, must be a number"),
            "escape: trigger_range_m es un texto, debe ser un número");
  EXPECT_EQ(spanish("escape: trigger_range_m is -1, must be > 0"), "escape: trigger_range_m es -1, debe ser > 0");
}

TEST(Wording, LeavesWhatItDoesNotKnowAsItIs) {
  EXPECT_EQ(spanish("nobody ever said this"), "nobody ever said this");
  EXPECT_EQ(worded("robot is missing: name the robot.toml it is drawn for", Language::English),
            "robot is missing: name the robot.toml it is drawn for");
}

TEST(Wording, KnowsTheEndsOfSentences) {
  EXPECT_EQ(spanish("\"Escpe\" is no kind of acting module; did you mean \"Escape\"?"),
            "\"Escpe\" no es un tipo de módulo de actuación; ¿quiso decir \"Escape\"?");
  EXPECT_EQ(spanish("the robot has no channel \"x\"; did you mean \"y\"?"),
            "el robot no tiene el canal \"x\"; ¿quiso decir \"y\"?");
}

TEST(Wording, LeavesNamesAsTheyAre) {
  EXPECT_EQ(spanish("\"goal\" has no outputs"), "\"goal\" no tiene salidas") << "an id, not the class of goals";
}

TEST(Wording, FollowsASentenceIntoTheSentencesWithinIt) {
  EXPECT_EQ(spanish("tcp://127.0.0.1:7007: the robot said goodbye: the simulation was ended"),
            "tcp://127.0.0.1:7007: el robot se despidió: se terminó la simulación");
  EXPECT_EQ(spanish("tcp://a:1: no answer for 10 s: is the robot switched on, and nobody else's?"),
            "tcp://a:1: sin respuesta durante 10 s: ¿está el robot encendido y no lo usa nadie más?");
  EXPECT_EQ(spanish("it differs: sonar: max: the robot has 3, the file 6"),
            "difiere: sonar: max: el robot tiene 3, el archivo 6");
  EXPECT_EQ(spanish("it is \"Nimrod\", 1 robot, 0.3 m long and 0.2 m wide, a tick each 0.1 s"),
            "es \"Nimrod\", 1 robot(s), de 0.3 m de largo y 0.2 m de ancho, un ciclo cada 0.1 s");
  EXPECT_EQ(spanish("goal 2 at cell 3, -4: reached"), "objetivo 2 en la celda 3, -4: alcanzado");
}

TEST(Wording, TakesNoLongerThanTheMessageIsLong) {
  const std::string hostile(19'000, '"');
  EXPECT_EQ(spanish("x is " + hostile).size(), spanish("x is " + hostile).size());
}

/// The messages of the checks are made in many places; what a broken drawing can say must be in the dictionary.
TEST(Wording, KnowsTheMessagesThatABrokenDrawingGives) {
  const std::filesystem::path folder = std::filesystem::path(GANGLION_SOURCE_DIR) / "experiments";
  const DocumentPlace place{folder / "nimrod/controller.toml", folder};
  const std::string text = read_file(place.file).value();
  const std::pair<const char*, const char*> slips[] = {
      {"format = 1\n", ""},
      {"robot = \"robot.toml\"", "robot = \"robto.toml\""},
      {"channel = \"compass.heading\"", "channel = \"compass.headin\""},
      {"kind = \"Escape\"", "kind = \"Escpe\""},
      {"kind = \"Escape\"", ""},
      {"in.left = \"clear_left.range\"", ""},
      {"in.left = \"clear_left.range\"", "in.lef = \"clear_left.range\""},
      {"in.left = \"clear_left.range\"", "in.left = \"sonar_lft\""},
      {"in.left = \"clear_left.range\"", "in.left = \"heading\""},
      {"in.left = \"clear_left.range\"", "in.left = \"clear_left.rnge\""},
      {"in.left = \"clear_left.range\"", "in.left = \"sonar_left.range\""},
      {"in.left = \"clear_left.range\"", "in.left = [\"sonar_left\", \"sonar_right\"]"},
      {"in.left = \"clear_left.range\"", "left = \"clear_left.range\""},
      {"trigger_range_m = 0.10", "trigger_range_m = \"0.10\""},
      {"trigger_range_m = 0.10", "trigger_range_m = -1"},
      {"trigger_range_m = 0.10", "triger_range_m = 0.1"},
      {"command = \"drive\"", "command = \"drve\""},
      {"command = \"drive\"", ""},
      {"[\"escape\", \"avoid\", \"hold\"]", "[\"escape\", \"avoid\", \"heading\"]"},
      {"[\"escape\", \"avoid\", \"hold\"]", "[\"escape\", \"avoid\"]"},
      {"[\"escape\", \"avoid\", \"hold\"]", "[\"escape\", \"avoid\", \"hold\", \"avoid\"]"},
      {"id = \"avoid\"", "id = \"escape\""},
      {"id = \"avoid\"", "id = \"1avoid\""},
      {"id = \"avoid\"", ""},
      {"readings = 1", "readings = 1.5"},
  };
  for (const auto& [old, by] : slips) {
    std::string broken = text;
    ASSERT_NE(broken.find(old), std::string::npos) << old;
    broken.replace(broken.find(old), std::string_view(old).size(), by);
    const Drawing drawing = open_drawing(broken, place);
    EXPECT_FALSE(drawing.problems.empty()) << old << " -> " << by;
    for (const DrawingProblem& problem : drawing.problems) {
      EXPECT_NE(spanish(problem.error.message), problem.error.message) << problem.error.message;
    }
  }
}

TEST(Wording, FillsEveryHoleOfASpanishSentence) {
  for (const Phrase& phrase : spanish_phrases()) {
    std::size_t holes = 0;
    for (std::size_t at = phrase.en.find("{}"); at != std::string_view::npos; at = phrase.en.find("{}", at + 2))
      ++holes;
    for (char digit = '0'; digit <= '9'; ++digit) {
      const std::string hole = std::string("{") + digit + "}";
      if (phrase.es.find(hole) == std::string_view::npos) continue;
      EXPECT_LT(static_cast<std::size_t>(digit - '0'), holes) << phrase.es;
    }
    EXPECT_EQ(phrase.es.find("{}"), std::string_view::npos) << phrase.es;
  }
}

}  // namespace
}  // namespace ganglion::studio
