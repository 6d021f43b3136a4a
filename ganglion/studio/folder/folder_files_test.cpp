#include "ganglion/studio/folder/folder_files.h"

#include <gtest/gtest.h>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"

namespace ganglion::studio {
namespace {

namespace fs = std::filesystem;

class FolderFilesTest : public FolderTest {
 protected:
  FolderFilesTest() { fs::create_directories(folder_ / "in"); }
  void put(const std::string& name, const std::string& text) const { ASSERT_TRUE(write_file(folder_ / name, text)); }
  ErrorCode refusal(FolderFiles& files, const fs::path& named) const {
    const auto opened = files.open("any", named.string(), -1, 100);
    EXPECT_FALSE(opened) << named;
    return opened ? ErrorCode::Syntax : opened.error().code;
  }
};

TEST_F(FolderFilesTest, ReadsWhatLiesBelowAndNothingElse) {
  put("in/a/rules.txt", "r");
  put("secret.txt", "s");
  const Folder folder = Folder::open(folder_ / "in").value();
  FolderFiles files(folder);
  const int drawn = files.hold("controller", folder.root() / "a/c.toml", "");
  EXPECT_EQ(*files.at(files.open("rules", "rules.txt", drawn, 100).value()).text, "r");
  EXPECT_EQ(refusal(files, folder.root() / "none.txt"), ErrorCode::NotFound);
  EXPECT_EQ(files.outside(), "");
  EXPECT_EQ(files.open("rules", "../../secret.txt", drawn, 100).error().code, ErrorCode::BadParameter);
  EXPECT_EQ(files.outside().filename(), "secret.txt");
  EXPECT_EQ(refusal(files, folder_ / "secret.txt"), ErrorCode::BadParameter);
  fs::create_symlink(folder_ / "secret.txt", folder_ / "in/link.txt");
  EXPECT_EQ(refusal(files, folder.root() / "link.txt"), ErrorCode::BadParameter);
  fs::create_symlink("loop", folder_ / "in/loop");
  EXPECT_EQ(refusal(files, folder.root() / "loop"), ErrorCode::BadParameter)
      << "leads nowhere that is known to lie below";
  EXPECT_EQ(refusal(files, folder.root() / "a"), ErrorCode::Unreadable);
  EXPECT_EQ(files.open("rules", "rules.txt", drawn, 0).value(), 1) << "what was read stays";
  EXPECT_EQ(files.opened().size(), 2u);
}

}  // namespace
}  // namespace ganglion::studio
