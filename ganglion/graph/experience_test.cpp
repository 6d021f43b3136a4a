#include <gtest/gtest.h>

#include "ganglion/graph/testing/rig.h"

namespace ganglion {
namespace {

using testing::Rig, testing::seeker, testing::sensations, testing::wish;

/// Two Seekers, which remember their steps; sensations and goals have nothing to remember.
const std::string kLearners = sensations({"place"}) + wish("wish", "values = [9]") + seeker("upper", "wish") +
                              seeker("lower", "upper", "relative = true\ncommand = \"move\"");

Rig experienced() {
  Rig rig(kLearners);
  rig.tick();
  rig.set("place", 1);
  rig.tick();
  return rig;
}

TEST(Experience, ComesBackAsItWasSaved) {
  const std::vector<ModuleExperience> saved = experienced().controller.experience();
  ASSERT_EQ(saved.size(), 2u);
  EXPECT_EQ(saved[0].component, "upper");
  EXPECT_EQ(saved[0].kind, "Seeker");
  EXPECT_EQ(saved[0].version, 1u);
  ByteReader reader(saved[0].parts.at(0).bytes);
  EXPECT_EQ(reader.f64(), 1);  // its waypoints
  EXPECT_EQ(reader.f64(), 2);
  EXPECT_TRUE(reader.complete());

  Rig fresh(kLearners);
  Problems problems;
  fresh.controller.load(saved, problems);
  EXPECT_TRUE(problems.empty()) << problems.text();
  EXPECT_EQ(fresh.controller.experience().at(1).parts.at(0).bytes, saved[1].parts.at(0).bytes);
  fresh.tick();
  EXPECT_EQ(fresh.signal("upper.remembered"), 3);
}

TEST(Experience, SaysOnWhichParametersItRests) {
  const auto saved = experienced().controller.experience();
  EXPECT_EQ(saved[1].rests_on, (std::vector<RestsOn>{{"stride", "1"}, {"relative", "true"}}));
}

TEST(Experience, ThatRestsOnOtherValuesIsRefusedWithBoth) {
  auto saved = experienced().controller.experience();
  saved.resize(1);
  saved[0].rests_on = {{"stride", "0.5"}, {"relative", "false"}, {"of a newer program", "7"}};
  Rig rig(kLearners);
  Problems problems;
  rig.controller.load(saved, problems);
  ASSERT_EQ(problems.size(), 1u);
  const Error error = problems.sorted().front();
  EXPECT_EQ(error.what.en,
            "upper: was learned with stride = 0.5, and stride is 1 now; set it back, or drop what was learned by "
            "\"ganglion experience forget\"");
  EXPECT_EQ(error.what.es,
            "upper: se aprendió con stride = 0.5, y ahora stride es 1; vuelva a ponerlo, u olvide lo aprendido con "
            "\"ganglion experience forget\"");
  EXPECT_EQ(error.subject.component, "upper");
  EXPECT_EQ(error.subject.choices, std::vector<std::string>{"0.5"});
  EXPECT_TRUE(rig.controller.experience().at(0).parts.at(0).bytes.empty()) << "left alone";
}

TEST(Experience, ThatDoesNotSayOnWhatItRestsIsTaken) {
  auto saved = experienced().controller.experience();
  for (ModuleExperience& one : saved) one.rests_on.clear();
  Rig rig(kLearners);
  Problems problems;
  rig.controller.load(saved, problems);
  EXPECT_TRUE(problems.empty()) << problems.text();
}

TEST(Experience, IsToldOfByTheRequestsThatWereConcluded) {
  Rig rig(kLearners);
  EXPECT_EQ(rig.controller.concluded(), 0u);
  rig.tick();  // the wish for 9 asks the upper one, and that one the lower one for its first step
  EXPECT_EQ(rig.controller.concluded(), 0u);
  rig.set("place", 1);
  rig.tick();  // the step is done
  EXPECT_EQ(rig.controller.concluded(), 1u);
  rig.set("place", 9);
  rig.tick();  // and the wish
  EXPECT_GE(rig.controller.concluded(), 2u);
}

TEST(Experience, ThatNoComponentClaimsIsReportedAndLeftAlone) {
  Rig rig(kLearners);
  Problems problems;
  rig.controller.load({{"elsewhere", "Seeker", 1, {}}, {"upper", "Walker", 1, {}}, {"place", "", 1, {}}}, problems);
  EXPECT_EQ(problems.text(),
            "experience of \"elsewhere\" (Seeker) belongs to no component of this controller; "
            "\"ganglion experience rename\" can give it to \"lower\"\n"
            "experience of \"place\" () belongs to no component of this controller\n"
            "experience of \"upper\" (Walker) belongs to no component of this controller\n");
}

TEST(Experience, ThatIsDamagedOrNewerIsReportedWithItsComponent) {
  Rig rig = experienced();
  const auto before = rig.controller.experience().at(0).parts.at(0).bytes;
  Problems problems;
  rig.controller.load({{"upper", "Seeker", 1, {{"steps", std::vector<std::byte>(7)}}}, {"lower", "Seeker", 2, {}}},
                      problems);
  EXPECT_EQ(problems.text(), "lower: version 2 is newer than 1\nupper: no steps\n");
  EXPECT_EQ(rig.controller.experience().at(0).parts.at(0).bytes, before);
}

}  // namespace
}  // namespace ganglion
