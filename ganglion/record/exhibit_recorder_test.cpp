#include "ganglion/record/exhibit_recorder.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "ganglion/record/exhibit/exhibit_codec.h"
#include "ganglion/record/exhibit/testing/shows_all.h"

namespace ganglion {
namespace {

struct Heard final : RunSink {
  explicit Heard(bool keeps) : keeps_all(keeps) {}
  int add_table(std::string_view, std::span<const SignalColumn>) override { return 0; }
  void write_row(int, std::uint32_t, double, std::span<const double>) override {}
  void write_json(std::string_view topic, std::string_view schema, double, std::string_view) override {
    EXPECT_EQ(schema, "foxglove.Grid");
    views.emplace_back(topic);
  }
  void write_exhibit(std::string_view topic, double, std::string_view bytes) override {
    topics.emplace_back(topic);
    const auto exhibit = decode_exhibit(bytes);
    ASSERT_TRUE(exhibit) << topic;
    exhibits.push_back(*exhibit);
  }
  bool archives() const noexcept override { return keeps_all; }
  bool keeps_all;
  std::vector<std::string> topics, views;
  std::vector<shown::Exhibit> exhibits;
};

TEST(ExhibitRecorder, WritesEverythingOnceAndWhatDidNotChangeNever) {
  Heard heard(true);
  ExhibitRecorder recorder(heard);
  ShowsAll all;
  recorder.show(all, {0, "all"}, 0);
  ASSERT_EQ(heard.topics.size(), 8u);
  EXPECT_EQ(heard.topics[0], "/robot0/exhibit/all/field/meadow");
  EXPECT_EQ(heard.views, (std::vector<std::string>{"/robot0/map/all/meadow"}));  // no view of a field that lies nowhere
  recorder.show(all, {0, "all"}, 1);
  EXPECT_EQ(heard.topics.size(), 8u);
  recorder.show(all, {1, "all"}, 1);
  EXPECT_EQ(heard.topics.size(), 16u);
}

TEST(ExhibitRecorder, WritesTheRectangleThatChanged) {
  Heard heard(true);
  ExhibitRecorder recorder(heard);
  ShowsAll all;
  recorder.show(all, {0, "all"}, 0);
  all.stage = 1;
  recorder.show(all, {0, "all"}, 1);
  ASSERT_EQ(heard.topics.size(), 10u);  // the field and the bars
  const auto* patch = std::get_if<shown::Patch>(&heard.exhibits[8].form);
  ASSERT_NE(patch, nullptr);
  EXPECT_EQ(patch->column, 4);  // the cell of index 20 in rows of 8
  EXPECT_EQ(patch->row, 2);
  EXPECT_EQ(patch->columns * patch->rows, 1);
  EXPECT_EQ(heard.topics[9], "/robot0/exhibit/all/bars/firing");
}

TEST(ExhibitRecorder, TellsOnlookersWholeFieldsAndNoViews) {
  Heard heard(false);
  ExhibitRecorder recorder(heard);
  ShowsAll all;
  recorder.show(all, {0, "all"}, 0);
  all.stage = 1;
  recorder.show(all, {0, "all"}, 1);
  ASSERT_EQ(heard.topics.size(), 10u);
  EXPECT_TRUE(std::holds_alternative<shown::Field>(heard.exhibits[8].form));
  EXPECT_TRUE(heard.views.empty());
}

struct Costly final : Exhibitor {
  void show(Exhibition& to) const override {
    if (!to.lacks("map", generation)) return;
    ++gathered;
    const std::array<float, 1> value = {0.5F};
    const std::array<Layer, 1> layers = {{{.name = "l", .values = value}}};
    to.field({.name = "map", .columns = 1, .rows = 1, .layers = layers, .generation = generation});
  }
  std::uint64_t generation = 1;
  mutable int gathered = 0;
};

TEST(ExhibitRecorder, HasNothingGatheredThatItAlreadyHas) {
  Heard heard(true);
  ExhibitRecorder recorder(heard);
  Costly costly;
  for (int i = 0; i < 3; ++i) recorder.show(costly, {0, "a"}, i);
  EXPECT_EQ(costly.gathered, 1);
  costly.generation = 2;
  recorder.show(costly, {0, "a"}, 3);
  EXPECT_EQ(costly.gathered, 2);
  EXPECT_EQ(heard.topics.size(), 1u);  // looked at, but the same
  recorder.show(costly, {1, "a"}, 3);  // another robot's has its own memory
  EXPECT_EQ(costly.gathered, 3);
}

}  // namespace
}  // namespace ganglion
