#include "ganglion/record/exhibit/exhibit_json.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "ganglion/record/exhibit/testing/shows_all.h"

namespace ganglion {
namespace {

TEST(ExhibitJson, SaysEverythingInBothLanguages) {
  KeepsShown kept({0, "all"});
  ShowsAll().show(kept);
  std::map<std::string, nlohmann::json> said;
  for (const ExhibitTrack& track : kept.tracks) said[track.form + "/" + track.name] = json_of(track.states.back());
  EXPECT_EQ(said["field/meadow"]["layers"][2]["classes"][1]["title"]["es"], "una roca");
  EXPECT_EQ(said["field/meadow"]["layers"][2]["classes"][1]["byte"], 127);
  EXPECT_EQ(said["field/rules"]["across"]["ticks"][0]["es"], "cerca");
  EXPECT_EQ(said["curve/terms"]["lines"][1]["title"]["en"], "fit");
  EXPECT_EQ(said["bars/firing"]["bars"][2]["value"], -0.4);
  EXPECT_EQ(said["network/causes"]["edges"][0],
            nlohmann::json({{"from", 0}, {"to", 1}, {"weight", 1}, {"role", "plan"}}));
  EXPECT_EQ(said["frame/nose"]["columns"][2], "truth.yaw_rad");
  EXPECT_EQ(said["marks/marks"]["shapes"][2]["id"], "goal 1");
  EXPECT_EQ(said["marks/marks"]["shapes"][0]["xy"], nlohmann::json({0.5, 0.5, 2, 1, 3.5, 3}));
}

TEST(ExhibitJson, HasNullForWhatIsNoNumber) {
  const shown::Bars bars{{}, {{{}, std::numeric_limits<double>::quiet_NaN(), Role::Plain}}};
  EXPECT_TRUE(json_of(shown::Exhibit{{}, bars})["bars"][0]["value"].is_null());
}

// The page cannot ask C++ while it is built: it has a copy.
TEST(Roles, AreTheSameInTheStudio) {
  const std::filesystem::path path = std::filesystem::path(GANGLION_SOURCE_DIR) / "studio/src/api/roles.json";
  std::ifstream file(path);
  const auto copy = nlohmann::json::parse(file, nullptr, false);
  EXPECT_EQ(copy, roles_json()) << path << " must hold:\n" << roles_json().dump(2);
}

}  // namespace
}  // namespace ganglion
