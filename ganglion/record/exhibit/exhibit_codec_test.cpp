#include "ganglion/record/exhibit/exhibit_codec.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "ganglion/random/draws.h"
#include "ganglion/record/exhibit/exhibit.pb.h"
#include "ganglion/record/exhibit/keep.h"
#include "ganglion/record/exhibit/testing/shows_all.h"

namespace ganglion {
namespace {

/// Everything that ShowsAll shows, encoded.
struct Gathered final : Exhibition {
  bool lacks(std::string_view, std::uint64_t) override { return true; }
  void frame(const FrameExhibit& one) override { add(shown::keep(one)); }
  void field(const FieldExhibit& one) override { add(shown::keep(one)); }
  void curve(const CurveExhibit& one) override { add(shown::keep(one)); }
  void bars(const BarExhibit& one) override { add(shown::keep(one)); }
  void marks(const MarkExhibit& one) override { add(shown::keep(one)); }
  void network(const NetworkExhibit& one) override { add(shown::keep(one)); }
  void add(const std::optional<shown::Exhibit>& one) {
    ASSERT_TRUE(one);
    bytes.push_back(encode(*one));
  }
  std::vector<std::string> bytes;
};

Gathered gathered() {
  Gathered all;
  ShowsAll().show(all);
  return all;
}

TEST(ExhibitCodec, GivesBackEveryForm) {
  const Gathered all = gathered();
  ASSERT_EQ(all.bytes.size(), 8u);  // two fields, two frames, marks, curve, bars, network
  std::set<std::size_t> forms;
  for (const std::string& bytes : all.bytes) {
    const auto exhibit = decode_exhibit(bytes);
    ASSERT_TRUE(exhibit);
    forms.insert(exhibit->form.index());
    EXPECT_EQ(encode(*exhibit), bytes);
  }
  EXPECT_EQ(forms.size(), 6u);
}

TEST(ExhibitCodec, KeepsWordsScalesAndWhatIsUnknown) {
  const auto exhibit = decode_exhibit(gathered().bytes[0]);
  ASSERT_TRUE(exhibit);
  EXPECT_EQ(exhibit->title, (Sentence{"Meadow", "Prado"}));
  const auto& field = std::get<shown::Field>(exhibit->form);
  ASSERT_EQ(field.layers.size(), 3u);
  EXPECT_EQ(field.layers[0].title.es, "Calor");
  EXPECT_EQ(field.layers[0].unit, "degC");
  EXPECT_EQ(field.layers[2].classes[1].title.en, "a rock");
  EXPECT_EQ(field.cells[0][0], shown::kUnknownCell);
  EXPECT_EQ(field.cells[0][1], 25);  // 12 between 10 and 30 of 254
}

/// Takes it or not, but never breaks what is promised.
void look_into(const std::string& bytes) {
  const auto exhibit = decode_exhibit(bytes);
  if (!exhibit) return;
  if (const auto* field = std::get_if<shown::Field>(&exhibit->form)) {
    for (const auto& cells : field->cells) {
      EXPECT_EQ(cells.size(), static_cast<std::size_t>(field->columns) * static_cast<std::size_t>(field->rows));
    }
    EXPECT_EQ(field->cells.size(), field->layers.size());
  }
  if (const auto* network = std::get_if<shown::Network>(&exhibit->form)) {
    for (const auto& edge : network->edges) EXPECT_LT(edge.to, static_cast<int>(network->nodes.size()));
  }
}

TEST(ExhibitCodec, SurvivesChangedBytes) {
  Draws draws(StreamId{.seed = 5}, 0);
  for (const std::string& good : gathered().bytes) {
    for (int round = 0; round < 400; ++round) {
      std::string bytes = good;
      for (int k = 0; k < 3; ++k) {
        bytes[static_cast<std::size_t>(draws.uniform() * static_cast<double>(bytes.size()))] =
            static_cast<char>(draws.uniform() * 256);
      }
      look_into(bytes);
      look_into(good.substr(0, static_cast<std::size_t>(draws.uniform() * static_cast<double>(good.size()))));
    }
  }
}

/// The message of a field of one layer, 2 x 1 cells, as it should be.
Exhibit sound_field() {
  Exhibit message;
  auto& field = *message.mutable_field();
  field.set_cell_x(1);
  field.set_cell_y(1);
  field.set_columns(2);
  field.set_rows(1);
  field.add_layers()->set_high(1);
  field.add_cells("ab");
  return message;
}

TEST(ExhibitCodec, RefusesSizesAndNumbersThatCannotBe) {
  ASSERT_TRUE(decode_exhibit(sound_field().SerializeAsString()));
  const std::vector<void (*)(Exhibit_Field&)> faults = {
      [](Exhibit_Field& f) { f.set_columns(3); },
      [](Exhibit_Field& f) { f.set_columns(0xffffffff); },
      [](Exhibit_Field& f) { f.set_rows(0); },
      [](Exhibit_Field& f) { f.set_cell_x(0); },
      [](Exhibit_Field& f) { f.set_cell_y(std::numeric_limits<double>::quiet_NaN()); },
      [](Exhibit_Field& f) { f.set_x(std::numeric_limits<double>::infinity()); },
      [](Exhibit_Field& f) { f.mutable_layers(0)->set_high(0); },
      [](Exhibit_Field& f) {
        f.mutable_layers(0)->set_low(-std::numeric_limits<double>::max());
        f.mutable_layers(0)->set_high(std::numeric_limits<double>::max());
      },
      [](Exhibit_Field& f) { f.add_cells("ab"); },
      [](Exhibit_Field& f) { f.mutable_cells(0)->push_back('c'); },
      [](Exhibit_Field& f) { f.mutable_layers(0)->set_name(std::string(401, 'x')); },
      [](Exhibit_Field& f) { f.set_columns(1 << 13), f.set_rows(1 << 13); }};
  for (std::size_t i = 0; i < faults.size(); ++i) {
    Exhibit message = sound_field();
    faults[i](*message.mutable_field());
    EXPECT_FALSE(decode_exhibit(message.SerializeAsString())) << i;
  }
}

TEST(ExhibitCodec, LeavesOutWhatCannotBeDrawn) {
  const std::array<Vector2, 2> lost = {{{std::numeric_limits<double>::quiet_NaN(), 0}, {1, 1}}};
  const std::array<Shape, 2> shapes = {{{.points = lost}, {.points = std::span(lost).first(1)}}};
  const auto marks = shown::keep(MarkExhibit{.name = "m", .shapes = shapes});
  ASSERT_TRUE(marks);
  ASSERT_EQ(std::get<shown::Marks>(marks->form).shapes.size(), 1u);
  EXPECT_EQ(std::get<shown::Marks>(marks->form).shapes[0].points, (std::vector<Vector2>{{1, 1}}));
  const std::array<float, 3> three{};
  const std::array<Layer, 1> layers = {{{.name = "l", .values = three}}};
  EXPECT_FALSE(shown::keep(FieldExhibit{.name = "f", .columns = 2, .rows = 2, .layers = layers}));
  EXPECT_TRUE(shown::keep(FieldExhibit{.name = "f", .columns = 3, .rows = 1, .layers = layers}));
}

}  // namespace
}  // namespace ganglion
