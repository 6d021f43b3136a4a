#include "ganglion/config/testing/mutator.h"

#include <gtest/gtest.h>

#include "ganglion/config/format.h"
#include "ganglion/graph/testing/example_files.h"

// Files are hostile: whatever happens to a good one, it is rejected with a place in the file, or understood and the
// same after formatting. Never a crash, never a guess.
namespace ganglion {
namespace {

void expect_places(const std::vector<Error>& errors, const std::string& text) {
  EXPECT_FALSE(errors.empty());
  for (const Error& error : errors) {
    EXPECT_EQ(error.place.file, "c.toml") << error.text() << "\n" << text;
    EXPECT_GT(error.place.line, 0) << error.text() << "\n" << text;
    EXPECT_FALSE(error.what.en.empty()) << text;
  }
}

/// Whether the file was accepted.
bool judged(const std::string& text) {
  const auto file = config::parse(text, "c.toml");
  const auto formatted = config::format(text, "c.toml");
  EXPECT_EQ(file.has_value(), formatted.has_value()) << text;
  if (!file) {
    expect_places({file.error()}, text);
    return false;
  }
  const Problems problems = example::problems_of(*file);
  if (!problems.empty()) {
    expect_places(problems.sorted(), text);
    return false;
  }
  const auto again = config::parse(*formatted, "c.toml");
  EXPECT_TRUE(again && config::equal(*file, *again)) << text;
  EXPECT_TRUE(again && example::problems_of(*again).empty()) << text;
  EXPECT_EQ(*config::format(*formatted, "c.toml"), *formatted) << text;
  return true;
}

TEST(MutatedControllers, AreRejectedWithAPlaceOrUnderstoodAndKept) {
  int accepted = 0, rejected = 0;
  std::uint64_t seed = 1;
  for (const std::string& good : {example::kArbiter, example::kBehaviour, example::kLoops}) {
    config::Mutator mutator(seed++);
    ASSERT_TRUE(judged(good));
    for (int i = 0; i < 300; ++i) ++(judged(mutator.mutated(good)) ? accepted : rejected);
  }
  EXPECT_GT(accepted, 50);  // else the mutations are too rough to say anything
  EXPECT_GT(rejected, 500);
}

TEST(MutatedControllers, AreJudgedTheSameTwice) {
  config::Mutator mutator(9);
  for (int i = 0; i < 300; ++i) {
    const std::string text = mutator.mutated(example::kLoops);
    EXPECT_EQ(example::complaints(text), example::complaints(text));
  }
}

TEST(MutatedOverrides, AreRejectedWithAPlaceOrApplied) {
  constexpr std::string_view kGood[] = {"acting.back_off.trigger_range_m=0.3",
                                        "sensation.sonar_left.channel=sonar_right.range",
                                        "coordinator.arbiter.in.commands=[\"go\", \"back_off\"]",
                                        "name=\"A # name\"",
                                        "goal.charger.at_m = [3, 4]",
                                        "layout.go={ x = 1, y = 2 }"};
  config::Mutator mutator(4);
  int accepted = 0, rejected = 0;
  for (int i = 0; i < 300; ++i) {
    std::string text(kGood[mutator.below(std::size(kGood))]);
    if (i >= 6) text = mutator.mutated(text);
    const auto parsed = config::parse_override(text);
    auto file = config::parse(example::kArbiter, "c.toml");
    const auto applied = parsed ? config::apply(*file, *parsed) : Result<void>(tl::unexpected<Error>(parsed.error()));
    const Problems problems = applied ? example::problems_of(*file) : Problems();
    if (!applied) {
      EXPECT_NE(applied.error().text().find("--set "), std::string::npos) << applied.error().text();
    }
    for (const Error& error : problems.sorted()) {
      const bool placed = error.place.file.starts_with("--set ") || error.place.line > 0;
      EXPECT_TRUE(placed) << text << ": " << error.text();
    }
    ++(applied && problems.empty() ? accepted : rejected);
  }
  EXPECT_GT(accepted, 20);
  EXPECT_GT(rejected, 100);
}

TEST(HostileControllers, ComeToAnEnd) {
  std::string wires = "format = 1\n[[coordinator]]\nid = \"c\"\nkind = \"First\"\nin.commands = [";
  for (int i = 0; i < 100'000; ++i) wires += "\"x" + std::to_string(i) + "\", ";
  std::string chain = "format = 1\n";
  for (int i = 0; i < 5'000; ++i) {
    chain += fmt::format("[[sensing]]\nid = \"n{}\"\nkind = \"Nearest\"\nin.ranges = \"n{}.range\"\n", i, i + 1);
  }
  const std::string names = "format = 1\n[[acting]]\nkind = \"BackOff\"\nid = \"" + std::string(1'000'000, 'a') +
                            "\"\nin.left = \"" + std::string(1'000'000, '.') + "\"\n";
  for (const std::string& text : {wires + "]\n", chain, names}) {
    const auto file = config::parse(text, "c.toml");
    ASSERT_TRUE(file) << file.error().text();
    const Problems problems = example::problems_of(*file);
    expect_places(problems.sorted(), "");
    EXPECT_LT(problems.text().size(), 2'000'000u);
  }
}

}  // namespace
}  // namespace ganglion
