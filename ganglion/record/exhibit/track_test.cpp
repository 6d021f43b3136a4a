#include "ganglion/record/exhibit/track.h"

#include <gtest/gtest.h>

namespace ganglion {
namespace {

shown::Exhibit field_of(std::uint8_t fill) {
  shown::Field field;
  field.columns = 2;
  field.rows = 1;
  field.layers.resize(1);
  field.cells = {{fill, fill}};
  return {{"map", "mapa"}, field};
}
shown::Exhibit patch_at(int column, std::uint8_t value) { return {{}, shown::Patch{column, 0, 1, 1, {{value}}}}; }

TEST(ExhibitTopic, NamesOwnerFormAndName) {
  const auto track = track_of("/robot12/exhibit/router/field/map/of the house");
  ASSERT_TRUE(track);
  EXPECT_EQ(track->owner, (ExhibitOwner{12, "router"}));
  EXPECT_EQ(track->form, "field");
  EXPECT_EQ(track->name, "map/of the house");
  const auto whole = track_of("/exhibit/frame/pole");
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->owner, (ExhibitOwner{-1, ""}));
  for (const ExhibitTrack& one : {*track, *whole}) {
    const auto again = track_of(exhibit_topic(one.owner, one.form, one.name));
    ASSERT_TRUE(again);
    EXPECT_EQ(again->owner, one.owner);
    EXPECT_EQ(again->name, one.name);
  }
}

TEST(ExhibitTopic, IsNoneOfOtherTopics) {
  for (const char* topic : {"/robot0/signals", "/robot0/map/router", "/exhibit", "/exhibit/marks", "/exhibit/patch/x",
                            "/robot0/exhibit/router/field", "/robot/exhibit/a/field/b", "/robot-1/exhibit/a/field/b",
                            "/robot99999999999/exhibit/a/field/b", "exhibit/field/x", ""}) {
    EXPECT_FALSE(track_of(topic)) << topic;
  }
}

TEST(ExhibitTrack, TellsAFieldAsItWasAtAnyTime) {
  ExhibitTrack track = *track_of("/robot0/exhibit/router/field/map");
  EXPECT_FALSE(track.add(0, patch_at(0, 1)));  // of what?
  EXPECT_TRUE(track.add(1, field_of(7)));
  EXPECT_FALSE(track.add(0.5, patch_at(0, 1)));  // backwards
  EXPECT_FALSE(track.add(2, patch_at(2, 1)));    // outside
  EXPECT_FALSE(track.add(2, {{}, shown::Marks{}}));
  EXPECT_TRUE(track.add(2, patch_at(1, 3)));
  EXPECT_TRUE(track.add(3, field_of(0)));
  EXPECT_TRUE(track.add(4, patch_at(0, 9)));
  EXPECT_FALSE(field_at(track, 0.9));
  EXPECT_EQ(field_at(track, 1)->cells[0], (std::vector<std::uint8_t>{7, 7}));
  EXPECT_EQ(field_at(track, 2.5)->cells[0], (std::vector<std::uint8_t>{7, 3}));
  EXPECT_EQ(field_at(track, 3)->cells[0], (std::vector<std::uint8_t>{0, 0}));
  EXPECT_EQ(field_at(track, 99)->cells[0], (std::vector<std::uint8_t>{9, 0}));
  EXPECT_EQ(track.title().es, "mapa");
  std::vector<std::vector<std::uint8_t>> states;
  for_each_state(track, [&](double, const shown::Field& field) { states.push_back(field.cells[0]); });
  EXPECT_EQ(states, (std::vector<std::vector<std::uint8_t>>{{7, 7}, {7, 3}, {0, 0}, {9, 0}}));
}

TEST(ExhibitTrack, TellsMarksAsTheyWereAtAnyTime) {
  ExhibitTrack track = *track_of("/exhibit/marks/goals");
  EXPECT_TRUE(track.add(1, {{}, shown::Marks{}}));
  EXPECT_TRUE(track.add(2, {{}, shown::Marks{{shown::Shape{.points = {{1, 2}}}}}}));
  EXPECT_EQ(track.at<shown::Marks>(0.5), nullptr);
  EXPECT_EQ(track.at<shown::Marks>(1.5)->shapes.size(), 0u);
  EXPECT_EQ(track.at<shown::Marks>(2)->shapes.size(), 1u);
  EXPECT_EQ(track.at<shown::Bars>(2), nullptr);
}

}  // namespace
}  // namespace ganglion
