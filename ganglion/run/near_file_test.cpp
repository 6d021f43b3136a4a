#include "ganglion/run/near_file.h"

#include <gtest/gtest.h>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/run/check_file.h"

namespace ganglion {
namespace {

class NearFile : public FolderTest {
 protected:
  std::string said_of(const std::string& name) const {
    Problems problems;
    check_file(folder_ / name, problems);
    return problems.text();
  }
};

TEST_F(NearFile, IsNamedWhereAFileIsNotThere) {
  ASSERT_TRUE(write_file(folder_ / "experiments/nimrod/experiment.toml", "format = 1\n"));
  ASSERT_TRUE(write_file(folder_ / "office.toml", "format = 1\n"));
  EXPECT_NE(said_of("ofice.toml").find("did you mean \"" + (folder_ / "office.toml").string() + "\"?"),
            std::string::npos);
  const std::string meant = "did you mean \"" + (folder_ / "experiments/nimrod").string();
  EXPECT_NE(said_of("nimord").find(meant + "\"?"), std::string::npos) << said_of("nimord");
  EXPECT_NE(said_of("experiments/nimord").find(meant + "\"?"), std::string::npos);
  EXPECT_NE(said_of("experiments/nimord/experiment.toml").find(meant + "/experiment.toml\"?"), std::string::npos);
}

TEST_F(NearFile, IsNotMadeUpWhereNothingIsLikeIt) {
  ASSERT_TRUE(write_file(folder_ / "office.toml", "format = 1\n"));
  EXPECT_TRUE(said_of("nimord").ends_with("there is no such file\n")) << said_of("nimord");
}

TEST(KindOfFile, KnowsAWorldByAnyOfItsKeys) {
  for (const char* text : {"[[floor]]\nx_m = 0\n", "[[bump]]\n", "[[beacon]]\n", "area = [0, 0, 1, 1]\n",
                           "map = \"a.yaml\"\n", "material = \"soft\"\n", "[[wall]]\n", "[[mover]]\n"}) {
    EXPECT_EQ(kind_of_file(*config::parse(std::string("format = 1\n") + text, "")), "world") << text;
  }
  EXPECT_EQ(kind_of_file(*config::parse("format = 1\nname = \"a\"\n", "")), "");
  EXPECT_EQ(kind_of_file(*config::parse("[body]\n[[sensation]]\nname = \"a\"\n", "")), "robot");
}

}  // namespace
}  // namespace ganglion
