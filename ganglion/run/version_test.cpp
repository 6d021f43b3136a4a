#include "ganglion/run/version.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ganglion/base/file.h"

namespace ganglion {
namespace {

nlohmann::json of_studio(const char* file) {
  return nlohmann::json::parse(*read_file(std::filesystem::path(GANGLION_SOURCE_DIR) / "studio" / file));
}

TEST(Version, IsThatOfTheStudiosPage) {
  EXPECT_EQ(of_studio("package.json")["version"], kVersion);
  EXPECT_EQ(of_studio("package-lock.json")["version"], kVersion);
  EXPECT_EQ(of_studio("package-lock.json")["packages"][""]["version"], kVersion);
}

}  // namespace
}  // namespace ganglion
