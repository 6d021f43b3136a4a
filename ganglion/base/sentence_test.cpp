#include "ganglion/base/sentence.h"

#include <gtest/gtest.h>

#include "ganglion/base/text.h"

namespace ganglion {
namespace {

TEST(Say, FillsBothLanguages) {
  const Sentence said = say({"{} goals in {} s", "{} metas en {} s"}, 3, 1.5);
  EXPECT_EQ(said.en, "3 goals in 1.5 s");
  EXPECT_EQ(said.es, "3 metas en 1.5 s");
}

TEST(Say, LetsSpanishPutItsArgumentsInAnotherOrder) {
  EXPECT_EQ(say({"{0} of {1}", "de {1}, {0}"}, 1, 2).es, "de 2, 1");
}

TEST(Say, SaysArgumentsThatAreWordsInTheSameLanguage) {
  const Sentence inner = say({"a wall", "una pared"});
  const Sentence said = say({"{} and {}", "{} y {}"}, inner, Text{"a box", "una caja"});
  EXPECT_EQ(said.en, "a wall and a box");
  EXPECT_EQ(said.es, "una pared y una caja");
}

TEST(Say, LeavesNamesAndWordsOfOthersAsTheyAre) {
  const Sentence said = say({"\"{}\": {}", "\"{}\": {}"}, std::string("sonar"), Sentence::quoted("Connection refused"));
  EXPECT_EQ(said.es, "\"sonar\": Connection refused");
}

TEST(Say, TakesNoBraceOfAnArgumentForAPlace) { EXPECT_EQ(say({"{}", "{}"}, "{}").en, "{}"); }

TEST(Text, MayBeEmptyInBothLanguages) {
  EXPECT_TRUE((Text{"", ""}).empty());
  EXPECT_EQ((Text{"wall", "pared"}).in(Language::Spanish), "pared");
}

TEST(Sentence, IsAddedToInBothLanguages) {
  Sentence said = say({"a wall", "una pared"});
  said += suggestion("lft", std::vector<std::string>{"left"});
  EXPECT_EQ(said.en, "a wall; did you mean \"left\"?");
  EXPECT_EQ(said.es, "una pared; ¿quiso decir \"left\"?");
}

}  // namespace
}  // namespace ganglion
