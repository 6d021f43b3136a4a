#include "ganglion/application/ledger.h"

#include <gtest/gtest.h>

#include "ganglion/application/intervention.h"

namespace ganglion {
namespace {

TEST(LedgerForm, WordsARowInBothLanguages) {
  const LedgerForm form{"app",
                        {{"column", "", {}}, {"outcome", "", {{"set", "fijado"}, {"reached", "alcanzado"}}}},
                        {"goal {#} at {column}: {outcome} {nobody} {", "objetivo {#} en {column}: {outcome}"}};
  const std::array values = {4.5, 1.0};
  EXPECT_EQ(row_text(form, 2, values).en, "goal 3 at 4.5: reached {nobody} {");
  EXPECT_EQ(row_text(form, 2, values).es, "objetivo 3 en 4.5: alcanzado");
  EXPECT_EQ(row_text(form, 0, std::array{1.0, 2.0}).es, "objetivo 1 en 1: 2") << "a value without a word";
  EXPECT_EQ(row_text(form, 0, std::array{1.0, -1.0}).es, "objetivo 1 en 1: -1");
}

TEST(Intervention, IsWordedByItsDescriptor) {
  constexpr std::array<InterventionArgument, 1> kArguments = {{{"x_m", "m"}}};
  const InterventionDescriptor put{"put",   {"an obstacle", "un obstáculo"},
                                   "mover", kArguments,
                                   1,       {"\"{subject}\" put at {x_m} by robot {robot}", "{subject} en {x_m}"}};
  const Intervention what{"put", 2, "{x_m}", {{"x_m", 1.256}}};
  EXPECT_EQ(text_of(put, what).en, "\"{x_m}\" put at 1.26 by robot 2") << "what it is called is not looked into";
  EXPECT_EQ(arguments_of(put, what).value(), std::vector<double>{1.256});
  EXPECT_EQ(arguments_of(put, {"put", 0, "", {}}).error().what.en, "an obstacle needs x_m, a finite number");
  EXPECT_EQ(arguments_of(put, {"put", 0, "", {{"x_m", 1}, {"z_m", 2}}}).error().what.es,
            "un obstáculo admite 1 números, no 2");
}

}  // namespace
}  // namespace ganglion
