#include <gtest/gtest.h>

#include "ganglion/plot/picture/fields/cells.h"
#include "ganglion/plot/picture/picture_kind.h"
#include "ganglion/plot/testing/markup.h"
#include "ganglion/plot/testing/sample_run.h"

namespace ganglion::plot {

extern const PictureKind fields_kind;

namespace {

TEST(Cells, AreThoseThatAreKnownAndOneMoreAround) {
  shown::Field field;
  field.origin = {10, 20};
  field.cell = {0.5, 1};
  field.columns = 4;
  field.rows = 2;
  field.layers.resize(1);
  field.cells = {{255, 255, 7, 255, 255, 9, 255, 255}};
  const Cells cells(field, 1);
  EXPECT_EQ(cells.lower(), (Vector2{10, 19}));
  EXPECT_EQ(cells.upper(), (Vector2{12, 23}));
  std::vector<std::pair<Vector2, int>> seen;
  cells.for_each(0, [&](Vector2 lower, std::uint8_t byte) { seen.emplace_back(lower, byte); });
  EXPECT_EQ(seen, (std::vector<std::pair<Vector2, int>>{{{11, 20}, 7}, {{10.5, 21}, 9}}));
}

TEST(FieldsPicture, IsDrawnForLayersOfClassesAlone) {
  RunView run = sample_router_run();
  auto& map = std::get<shown::Field>(run.exhibits[0].states.back().form);
  map.layers.erase(map.layers.begin() + 1);
  map.cells.erase(map.cells.begin() + 1);
  const auto words = words_in(fields_kind.draw(run, Language::English).at(0));
  for (const char* word : {"cells", "nature", "inhibition", "occupied", "static"}) {
    EXPECT_TRUE(words.contains(word)) << word;
  }
}

}  // namespace
}  // namespace ganglion::plot
