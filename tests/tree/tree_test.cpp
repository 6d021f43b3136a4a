#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>

#include "tests/tree/tree_check.h"

namespace ganglion::tree {
namespace {

const std::filesystem::path kRoot = GANGLION_SOURCE_DIR;

std::string text_of(const std::string& file) {
  std::ifstream stream(kRoot / file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

const std::vector<std::string>& files() {
  static const std::vector<std::string> kFiles = source_files(kRoot);
  return kFiles;
}

std::string told(const Findings& findings) {
  std::string lines;
  for (const Finding& finding : findings) lines += finding.text() + "\n";
  return lines;
}

/// What a check finds in all files.
std::string found(const std::function<Findings(const std::string&, const std::string&)>& check) {
  std::string lines;
  for (const std::string& file : files()) lines += told(check(file, text_of(file)));
  return lines;
}

TEST(Tree, KeepsTheOrderOfItsLayers) {
  const Layers layers = parse_layers(text_of("cmake/GanglionTargets.cmake"));
  ASSERT_GT(layers.size(), 10u);
  EXPECT_EQ(found([&](const auto& file, const auto& text) { return check_includes(file, text, layers); }), "");
}

TEST(Tree, HasNoFileTooLongToRead) {
  EXPECT_EQ(found([](const auto& file, const auto& text) { return check_length(file, text, 400); }), "");
}

TEST(Tree, CallsNeitherLibmNorClocksNorChanceInTicks) {
  EXPECT_EQ(found([](const auto& file, const auto& text) {
              return is_tick_code(file) ? check_tick_calls(file, text) : Findings();
            }),
            "");
}

TEST(Tree, NamesNoPathOfOneMachine) { EXPECT_EQ(found(check_machine_paths), ""); }

TEST(Tree, TestsEveryFolderOfSources) { EXPECT_EQ(told(check_tests(files(), text_of)), ""); }

TEST(Tree, IsSeenAtAll) {
  EXPECT_GT(files().size(), 100u);
  for (const char* file : {"ganglion/base/result.h", "tests/tree/tree_test.cpp", "CMakeLists.txt"}) {
    EXPECT_EQ(std::count(files().begin(), files().end(), file), 1) << file;
  }
}

const Layers kLayers = {{"base"}, {"module"}, {"acting", "sim"}, {"graph"}};

TEST(Layers, AreReadFromTheBuild) {
  EXPECT_EQ(
      parse_layers("# comment\nset(GANGLION_LAYERS\n  \"base\" \"module\"\n  \"acting|sim\" \"graph\")\nset(X \"y\")"),
      kLayers);
  EXPECT_TRUE(parse_layers("set(OTHER \"base\")").empty());
}

TEST(CheckIncludes, FindsLaterLayersNeighboursAndStrangers) {
  const auto check = [](const char* file, const char* text) { return told(check_includes(file, text, kLayers)); };
  EXPECT_EQ(check("ganglion/module/a.h", "#pragma once\n\n#include \"ganglion/graph/model.h\"\n"),
            "ganglion/module/a.h:3: ganglion/module must not use ganglion/graph\n");
  EXPECT_EQ(check("ganglion/acting/a/a.cpp", "  #  include \"ganglion/sim/world/world.h\"  // why\n"),
            "ganglion/acting/a/a.cpp:1: ganglion/acting must not use ganglion/sim\n");
  EXPECT_EQ(check("ganglion/graph/a.cpp", "#include \"ganglion/nowhere/a.h\"\n"),
            "ganglion/graph/a.cpp:1: ganglion/graph must not use ganglion/nowhere\n");
  EXPECT_EQ(check("ganglion/nowhere/a.cpp", ""),
            "ganglion/nowhere/a.cpp:1: ganglion/nowhere is not in GANGLION_LAYERS\n");
  EXPECT_EQ(
      check("ganglion/graph/a.cpp", "#include \"ganglion/sim/a.h\"\n#include \"ganglion/graph/b.h\"\n#include <map>\n"),
      "");
  EXPECT_EQ(check("ganglion/acting/a/a_test.cpp", "#include \"ganglion/graph/testing/rig.h\"\n"), "");
}

TEST(CheckLength, CountsLines) {
  EXPECT_EQ(told(check_length("a.cpp", "1\n2\n3\n", 3)), "");
  EXPECT_EQ(told(check_length("a.cpp", "1\n2\n3\n4\n", 3)), "a.cpp:4: has 4 lines; split it, the limit is 3\n");
}

TEST(CheckTickCalls, FindsLibmClocksAndChance) {
  const auto lines = [](const char* text) { return check_tick_calls("a.cpp", text).size(); };
  for (const char* bad : {"x = std::sin(y);", "x = atan2(y, z);", "return ::powf (y, 2);", "x = -exp(y);",
                          "auto t = std::chrono::steady_clock::now();", "std::mt19937 random(1);", "std::rand();",
                          "std::normal_distribution<> d;", "f(1'000, hypot(x, y));"}) {
    EXPECT_EQ(lines(bad), 1u) << bad;
  }
  for (const char* good :
       {"x = math::sin(y);", "x = ganglion::math::atan2(y, z);", "x = std::sqrt(y);", "// std::sin(y)",
        "\"std::sin(y)\"", "/* exp(\n) */", "x = fuzzy.exp(y);", "p->log(y);", "asin_table(y);", "R\"(std::cos(x))\"",
        "char c = '\"'; // std::tan(\"", "std::fmod(x, y)"}) {
    EXPECT_EQ(lines(good), 0u) << good;
  }
  EXPECT_EQ(check_tick_calls("a.cpp", "// one\n/* two\n*/ x = std::log(y);\n").front().line, 3);
}

TEST(CheckTickCalls, AreForWhatRunsInTicksOnly) {
  EXPECT_TRUE(is_tick_code("ganglion/acting/escape/escape.cpp"));
  EXPECT_TRUE(is_tick_code("ganglion/graph/controller.cpp"));
  EXPECT_FALSE(is_tick_code("ganglion/acting/escape/escape_test.cpp"));
  EXPECT_FALSE(is_tick_code("ganglion/module/testing/bench.cpp"));
  EXPECT_FALSE(is_tick_code("ganglion/math/functions.cpp"));
  EXPECT_FALSE(is_tick_code("ganglion/plot/axis.cpp"));
  EXPECT_FALSE(is_tick_code("ganglion/sim/README.md"));
}

TEST(CheckMachinePaths, FindsThemAndLeavesOthersAlone) {
  const auto count = [](const std::string& text) { return check_machine_paths("a.md", text).size(); };
  for (const std::string folder : {"work", "home", "root", "tmp", "Users"}) {
    EXPECT_EQ(count("see /" + folder + "/me/a.txt"), 1u);
    EXPECT_EQ(count("/" + folder + "/a"), 1u);
    EXPECT_EQ(count("net" + folder + "/" + folder + "/a, ./" + folder + "/a, /" + folder), 0u);
  }
}

TEST(CheckTests, FindsFoldersWithoutOne) {
  const auto text = [](const std::string& file) {
    return std::string(file == "ganglion/a/a_test.cpp" ? "#include \"ganglion/f/deep/f.h\"\n" : "");
  };
  EXPECT_EQ(told(check_tests({"ganglion/a/a.cpp", "ganglion/a/a_test.cpp", "ganglion/a/g_test.cpp",
                              "ganglion/a/b/b.cpp", "ganglion/a/testing/c.cpp", "ganglion/d/d.h",
                              "ganglion/f/deep/f.cpp", "ganglion/g/x.cpp", "apps/e/e.cpp"},
                             text)),
            "ganglion/a/b:0: has sources and no test\n");
}

}  // namespace
}  // namespace ganglion::tree
