#include <gtest/gtest.h>

#include <cmath>

#include "ganglion/measure/testing/measure_bench.h"

namespace ganglion {

extern const MeasureKind contacts_kind;

namespace {

using testing::channels;
using testing::figure_names;
using Names = std::vector<std::string>;

TEST(Contacts, TellWhatIsKnownOfThem) {
  const auto both = channels({"fastest_contact_mps", "touching", "contacts"}), count = channels({"contacts"}),
             neither = channels({"touching"});
  EXPECT_EQ(figure_names(contacts_kind, {.truth = both}), (Names{"contacts", "fastest_contact_mps"}));
  EXPECT_EQ(figure_names(contacts_kind, {.truth = count}), Names{"contacts"});
  EXPECT_EQ(figure_names(contacts_kind, {.truth = neither}), Names{});
  EXPECT_EQ(figure_names(contacts_kind, {}), Names{});
  EXPECT_EQ(contacts_kind.figures({.truth = both})[0].unit, "");
  EXPECT_EQ(contacts_kind.figures({.truth = both})[1].unit, "m/s");
}

TEST(Contacts, AreThoseThatTheTruthHasCounted) {
  const auto truth = channels({"fastest_contact_mps", "touching", "contacts"});
  testing::MeasureBench bench(contacts_kind, {.truth = truth});
  bench.begin({0, 0, 0});
  EXPECT_EQ(bench.figure("contacts"), 0);
  bench.step({0.2, 1, 1});
  EXPECT_EQ(bench.figure("contacts"), 1);
  EXPECT_EQ(bench.figure("fastest_contact_mps"), 0.2);
  bench.step({0.2, 1, 1});  // it pushes on
  EXPECT_EQ(bench.figure("contacts"), 1);
  bench.step({0.3, 1, 3});
  EXPECT_EQ(bench.figure("contacts"), 3);
  EXPECT_EQ(bench.figure("fastest_contact_mps"), 0.3);
}

TEST(Contacts, AreNotKnownWhereNobodyCountsThem) {
  const auto truth = channels({"contacts", "fastest_contact_mps"});
  testing::MeasureBench bench(contacts_kind, {.truth = truth});
  bench.begin({});
  bench.step({});
  EXPECT_TRUE(std::isnan(bench.figure("contacts")));  // not 0: it might have hit something
  EXPECT_TRUE(std::isnan(bench.figure("fastest_contact_mps")));
}

}  // namespace
}  // namespace ganglion
