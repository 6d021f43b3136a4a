#include "ganglion/plot/pictures/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "ganglion/plot/testing/markup.h"
#include "ganglion/plot/testing/sample_run.h"

namespace ganglion::plot {
namespace {

std::string svg_of(const Picture& picture) {
  const auto svg = render(picture, PictureFormat::Svg);
  EXPECT_TRUE(svg) << picture.id << ": " << svg.error().what.en;
  return svg.value_or("");
}

std::set<std::string> words_of(const Picture& picture) {
  const auto texts = texts_in(svg_of(picture));
  return {texts.begin(), texts.end()};
}

/// The pictures of one kind.
std::vector<Picture> pictures_of(const RunView& run, const std::string& kind, Language language) {
  return all_pictures(run, language, std::vector{kind});
}

/// All texts of all pictures of a run.
std::set<std::string> words_of(const RunView& run, Language language) {
  std::set<std::string> words;
  for (const Picture& picture : all_pictures(run, language)) words.merge(words_of(picture));
  return words;
}

bool holds(const std::set<std::string>& words, std::initializer_list<const char*> wanted) {
  return std::ranges::all_of(wanted, [&](const char* word) { return words.contains(word); });
}

TEST(EveryPicture, IsWellFormedWithTitleAndDescription) {
  for (const RunView& run : {sample_behaviour_run(1, 30), sample_behaviour_run(3, 30), sample_router_run(),
                             sample_exhibits_run(), empty_run(), unreadable_run(), RunView{}})
    for (const Picture& picture : all_pictures(run, Language::Spanish)) {
      const std::string svg = svg_of(picture);
      EXPECT_EQ(fault_in_markup(svg), "") << run.name << " " << picture.id;
      EXPECT_NE(svg.find("<title id=\"title\">"), std::string::npos);
      EXPECT_NE(svg.find("<desc id=\"desc\">"), std::string::npos);
      EXPECT_EQ(svg.find("nan"), std::string::npos) << run.name << " " << picture.id;
      EXPECT_EQ(svg.find("inf"), std::string::npos) << run.name << " " << picture.id;
    }
}

TEST(EveryPicture, SaysNothingInEnglishToReadersOfSpanish) {
  const std::set<std::string> of_the_run{"all", "J", "x [m]", "y [m]", "1 m", "escape", "avoid", "navigate", "arbiter"};
  for (const RunView& run :
       {sample_behaviour_run(1, 30), sample_router_run(), sample_exhibits_run(), unreadable_run()}) {
    const auto english = words_of(run, Language::English);
    for (const std::string& word : words_of(run, Language::Spanish)) {
      const bool is_name = word.find('.') != std::string::npos || word.find('_') != std::string::npos;
      const bool has_letters = std::ranges::any_of(word, [](unsigned char c) { return std::isalpha(c) != 0; });
      if (has_letters && !is_name && !of_the_run.contains(word)) {
        EXPECT_FALSE(english.contains(word)) << word;
      }
    }
  }
}

TEST(TrajectoryPicture, ExplainsTheBehavioursThatDrove) {
  const RunView run = sample_behaviour_run(1, 60);
  EXPECT_TRUE(holds(words_of(pictures_of(run, "Trajectory", Language::English).at(0)),
                    {"Legend", "start", "end", "escape", "avoid", "navigate", "contact", "wall", "static obstacle",
                     "dynamic obstacle", "x [m]", "y [m]"}));
  EXPECT_FALSE(words_of(pictures_of(run, "Trajectory", Language::English).at(0)).contains("goal"));
}

TEST(TrajectoryPicture, HasTheLegendOfThePaperForARouter) {
  const RunView run = sample_router_run();
  EXPECT_TRUE(holds(words_of(pictures_of(run, "Trajectory", Language::Spanish).at(0)),
                    {"Leyenda", "inicio", "trayectoria", "objetivo", "objetivo abandonado", "intento fallido",
                     "obstáculo estático", "obstáculo dinámico"}));
}

TEST(TrajectoryPicture, NamesTheRobotsWhereThereAreSeveral) {
  const RunView run = sample_behaviour_run(3, 30);
  EXPECT_TRUE(holds(words_of(pictures_of(run, "Trajectory", Language::English).at(0)), {"robot0", "robot1", "robot2"}));
}

TEST(FieldsPicture, HasAScaleAndTheSignsOfAllClasses) {
  const RunView run = sample_router_run();
  const auto pictures = pictures_of(run, "Fields", Language::English);
  ASSERT_EQ(pictures.size(), 1u);
  EXPECT_TRUE(holds(words_of(pictures[0]),
                    {"risk", "0", "0.25", "0.5", "0.75", "1", "occupied", "dynamic", "inhibited", "unknown"}));
  EXPECT_FALSE(words_of(pictures[0]).contains("static"));  // has no sign
}

TEST(SignalPicture, ShowsEverySignalWithItsUnit) {
  const RunView run = sample_behaviour_run(1, 30);
  const auto pictures = pictures_of(run, "Signals", Language::English);
  ASSERT_EQ(pictures.size(), 1u);
  EXPECT_TRUE(holds(words_of(pictures[0]), {"truth.x_m [m]", "truth.yaw_rad [rad]", "sonar_left [m]", "arbiter.active",
                                            "drive.right", "time [s]"}));
}

TEST(SignalPicture, ExplainsOnlyTheSignsThatItHas) {
  RunView run = sample_behaviour_run(1, 30);
  SignalTable& signals = run.robots[0].signals;
  std::ranges::fill(signals.values, 0.5);
  const auto said = [&] { return words_of(pictures_of(run, "Signals", Language::English).at(0)); };
  for (const char* sign : {"no valid reading", "nothing in range", "too close"}) EXPECT_FALSE(said().contains(sign));
  signals.values[3] = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(said().contains("nothing in range"));
  EXPECT_FALSE(said().contains("too close"));
  signals.values[3] = -signals.values[3];
  EXPECT_TRUE(said().contains("too close"));
  EXPECT_FALSE(said().contains("nothing in range"));
  signals.values[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(said().contains("no valid reading"));
  EXPECT_FALSE(said().contains("too close"));
}

TEST(SignalPicture, SaysWhereThereWasNeverAReading) {
  const RunView run = unreadable_run();
  const auto texts = texts_in(svg_of(pictures_of(run, "Signals", Language::Spanish).at(0)));
  EXPECT_EQ(std::ranges::count(texts, "sin lectura válida"), 11);  // ten signals and the legend
}

TEST(SignalPicture, SplitsManySignalsOverPictures) {
  RunView run = sample_behaviour_run(1, 1);
  SignalTable& signals = run.robots[0].signals;
  signals = {};
  for (int i = 0; i < 130; ++i) signals.columns.push_back({"signal", ""});
  EXPECT_EQ(pictures_of(run, "Signals", Language::English).size(), 3u);
}

TEST(BehaviourPicture, NamesCoordinatorAndCandidates) {
  const RunView run = sample_behaviour_run(1, 30);
  EXPECT_TRUE(
      holds(words_of(pictures_of(run, "Behaviours", Language::Spanish).at(0)),
            {"arbiter", "escape", "avoid", "navigate", "conduce", "quiere, suprimido", "en reposo", "tiempo [s]"}));
}

TEST(FieldsPicture, HasAPanelForEveryContinuousLayerOfEveryField) {
  const RunView run = sample_exhibits_run();
  const auto english = pictures_of(run, "Fields", Language::English);
  ASSERT_EQ(english.size(), 2u);
  EXPECT_TRUE(holds(words_of(english[0]), {"Warmth [degC]", "Visits", "a rock", "a pit", "x [m]", "10", "30"}));
  EXPECT_TRUE(holds(words_of(english[1]), {"Firing", "Weight", "Learned [J]", "near", "fit", "far", "left", "right",
                                           "Distance [m]", "Side"}));
  const auto spanish = pictures_of(run, "Fields", Language::Spanish);
  EXPECT_TRUE(holds(words_of(spanish[0]), {"Calor [degC]", "Visitas", "una roca", "un foso"}));
  EXPECT_TRUE(holds(words_of(spanish[1]),
                    {"Activación", "Peso", "Aprendido [J]", "cerca", "lejos", "izquierda", "Distancia [m]", "Lado"}));
}

TEST(EveryPicture, SaysAllThatIsShownInBothLanguages) {
  const RunView run = sample_exhibits_run();
  EXPECT_TRUE(
      holds(words_of(run, Language::English),
            {"Distance [m]", "Degree", "near",     "fit",   "truth.x_m",  // the curve and its cursor
             "rule 1",       "rule 3", "Strength", "-0.4",  "0.9",        // the bars
             "hungry",       "fed",    "tired",                           // the network
             "the yard",     "home",   "plan",     "place", "echo",      "reference", "itself", "goal reached"}));
  EXPECT_TRUE(holds(words_of(run, Language::Spanish),
                    {"Distancia [m]", "Grado", "cerca", "bien", "regla 1", "Fuerza", "hambre", "saciado", "cansado",
                     "el patio", "casa", "lugar", "eco", "referencia", "sí mismo", "objetivo alcanzado"}));
}

TEST(PictureKinds, SayWhatTheyAreAndWhenTheyAreWanted) {
  std::set<std::string_view> names;
  for (const PictureKind* kind : picture_kinds()) {
    EXPECT_EQ(kind->descriptor.component_class, ComponentClass::Picture);
    EXPECT_FALSE(kind->descriptor.summary.empty());
    EXPECT_TRUE(names.insert(kind->descriptor.name).second);
    EXPECT_FALSE(kind->wants(RunView{})) << kind->descriptor.name;
  }
  EXPECT_TRUE(names.contains("Trajectory") && names.contains("Fields") && names.contains("Networks"));
}

TEST(EveryPicture, KeepsNamesThatCarryMarkupAsText) {
  RunView run = sample_router_run();
  run.name = "<script>alert(1)</script>";
  run.robots[0].name = "\"><svg onload=alert(1)>";
  run.exhibits[0].owner.name = "../../etc/passwd";
  std::get<shown::Field>(run.exhibits[0].states.back().form).layers[1].title = {"</svg><script>", "</svg><script>"};
  std::get<shown::Marks>(run.exhibits[2].states.back().form).shapes[3].label = {"<script>", "<script>"};
  run.robots[0].signals.columns[0].name = "]]><script>";
  for (const Picture& picture : all_pictures(run, Language::English)) {
    const std::string svg = svg_of(picture);
    EXPECT_EQ(fault_in_markup(svg), "");
    EXPECT_EQ(svg.find("<script"), std::string::npos);
    EXPECT_EQ(svg.find("<svg onload"), std::string::npos);
    EXPECT_EQ(picture.id.find_first_of("./<> "), std::string::npos) << picture.id;
  }
}

}  // namespace
}  // namespace ganglion::plot
