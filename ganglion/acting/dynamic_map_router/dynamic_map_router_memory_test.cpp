// What AmDmr keeps and shows: experience saved and loaded, exhibits for onlookers.
#include <gtest/gtest.h>

#include "ganglion/acting/dynamic_map_router/testing/grid_bot.h"

namespace ganglion {
namespace {

using testing::Drive;
using testing::GridBot;
using testing::open_ground;

TEST(DynamicMapRouter, DrivesAsWellAfterItsExperienceWasSavedAndLoaded) {
  const std::vector<std::string> room = {"........", "...##...", "....#...", "....#...", "...##...", "........"};
  GridBot teacher(room);
  Drive taught(teacher);
  for (int trip = 0; trip < 8; ++trip) {
    teacher.column = 1, teacher.row = 2, teacher.heading = 0, teacher.length = 0;
    taught.tick();
    ASSERT_EQ(taught.go(6, 2), RequestStatus::Satisfied);
  }
  const auto parts = stored_parts(taught.module(), dynamic_map_router_kind.encode);
  GridBot pupil(room);
  pupil.column = 1, pupil.row = 2;
  Drive drive(pupil);
  ASSERT_TRUE(drive.module().load(1, parts));
  ASSERT_EQ(drive.go(6, 2), RequestStatus::Satisfied);
  EXPECT_EQ(pupil.length, teacher.length);
  EXPECT_EQ(pupil.bumps, 0);
}

TEST(DynamicMapRouter, KeepsItsMapWhenWhatItShallLoadIsDamaged) {
  GridBot bot = open_ground();
  Drive drive(bot);
  ASSERT_EQ(drive.go(8, 5), RequestStatus::Satisfied);
  auto parts = stored_parts(drive.module(), dynamic_map_router_kind.encode);
  parts.back().bytes.pop_back();
  EXPECT_FALSE(drive.module().load(1, parts));
  EXPECT_FALSE(drive.module().load(3, {}));
  EXPECT_EQ(drive.module().map().explored(), 4);
}

struct Shown final : Exhibition {
  bool lacks(std::string_view, std::uint64_t generation) override { return generation != last; }
  void frame(const FrameExhibit&) override {}
  void curve(const CurveExhibit&) override {}
  void bars(const BarExhibit&) override {}
  void network(const NetworkExhibit&) override {}
  void field(const FieldExhibit& field) override {
    ++fields;
    last = field.generation;
    columns = field.columns;
    names.clear();
    sizes.clear();
    for (const Layer& layer : field.layers) {
      names.emplace_back(layer.name);
      sizes.push_back(layer.values.size());
    }
    origin = field.origin;
    label.assign(field.layers[0].values.begin(), field.layers[0].values.end());
  }
  void marks(const MarkExhibit& marks) override {
    auto& lines = marks.name == "route" ? route : attempts;
    lines.clear();
    for (const Shape& shape : marks.shapes) lines.emplace_back(shape.points.begin(), shape.points.end());
  }
  int fields = 0, columns = 0;
  std::uint64_t last = 0;
  Vector2 origin;
  std::vector<std::string> names;
  std::vector<std::size_t> sizes;
  std::vector<float> label;
  std::vector<std::vector<Vector2>> route, attempts;
};

TEST(DynamicMapRouter, ShowsItsMapAndRouteInMetres) {
  GridBot bot = open_ground();
  bot.blocks.insert({6, 5});
  Drive drive(bot);
  drive.bench().ask({7, 5});
  drive.tick();
  drive.tick();
  Shown shown;
  drive.module().show(shown);
  EXPECT_EQ(shown.names, (std::vector<std::string>{"label", "risk", "static", "inhibited"}));
  EXPECT_EQ(shown.sizes, (std::vector<std::size_t>(4, 64 * 64)));
  EXPECT_EQ(shown.origin, (Vector2{0, 0}));
  EXPECT_EQ(shown.label[5 * 64 + 5], 0.5F);  // explored and empty
  EXPECT_EQ(shown.label[5 * 64 + 6], 1);
  ASSERT_EQ(shown.route.size(), 1u);
  ASSERT_GE(shown.route[0].size(), 2u);
  EXPECT_EQ(shown.route[0].front(), (Vector2{2.75, 2.75}));
  EXPECT_EQ(shown.route[0].back(), (Vector2{3.75, 2.75}));
}

TEST(DynamicMapRouter, ShowsWhatItTriedAndGathersTheMapOnlyWhereItChanged) {
  GridBot bot = open_ground();
  bot.blocks.insert({6, 5});
  Drive drive(bot);
  drive.bench().ask({7, 5});
  drive.tick();
  drive.tick();
  Shown shown;
  drive.module().show(shown);
  drive.module().show(shown);
  EXPECT_EQ(shown.fields, 1);
  ASSERT_EQ(shown.attempts.size(), 1u);
  EXPECT_EQ(shown.attempts[0], (std::vector<Vector2>{{2.75, 2.75}, {3.25, 2.75}}));  // from where it stood to the cell
  for (int i = 0; i < 5; ++i) drive.tick();
  drive.module().show(shown);
  EXPECT_EQ(shown.fields, 2);
}

}  // namespace
}  // namespace ganglion
