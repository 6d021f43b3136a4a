#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>

#include "tests/tree/circles.h"
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

TEST(Tree, KeepsTheFloorsOfThePage) {
  const Layers floors = parse_floors(text_of("studio/src/floors.txt"));
  ASSERT_GT(floors.size(), 5u);
  EXPECT_EQ(found([&](const auto& file, const auto& text) { return check_floors(file, text, floors); }), "");
  for (const std::vector<std::string>& floor : floors) {
    for (const std::string& folder : floor)
      EXPECT_TRUE(std::filesystem::is_directory(kRoot / "studio/src" / folder)) << folder << " is in floors.txt only";
  }
}

/// What the files below a folder import, tests aside.
Imports imports_below(const std::string& root) {
  Imports all;
  for (const std::string& file : files()) {
    if (!file.starts_with(root) || is_test(file)) continue;
    for (const Import& import : imports_of(file, text_of(file)))
      if (!is_test(import.to)) all.push_back(import);
  }
  return all;
}

TEST(Tree, HasNoFoldersThatNameEachOtherInACircle) {
  for (const char* root : {"ganglion/", "studio/src/"}) {
    const Imports imports = imports_below(root);
    EXPECT_GT(imports.size(), 100u) << root;
    EXPECT_EQ(told(check_folder_circles(imports)), "");
  }
}

TEST(Tree, HasNoFilesOfThePageThatNameEachOtherInACircle) {
  EXPECT_EQ(told(check_file_circles(imports_below("studio/src/"))), "");
}

TEST(Tree, HasNoFileTooLongToRead) {
  EXPECT_EQ(found([](const auto& file, const auto& text) { return check_length(file, text, 400); }), "");
}

TEST(Tree, HasNoFunctionTooLongToRead) {
  EXPECT_EQ(found([](const auto& file, const auto& text) { return check_functions(file, text, 60); }), "");
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

TEST(Floors, AreReadFromTheirFile) {
  EXPECT_EQ(parse_floors("# the floors\n\nbase  # lowest\nmodule\nacting | sim   # beside each other\n graph\n"),
            kLayers);
}

TEST(CheckFloors, FindsFloorsAboveNeighboursAndStrangers) {
  const auto check = [](const char* file, const char* text) { return told(check_floors(file, text, kLayers)); };
  EXPECT_EQ(check("studio/src/module/a.ts", "\nimport { b } from '../graph/b';\n"),
            "studio/src/module/a.ts:2: studio/src/module must not use studio/src/graph\n");
  EXPECT_EQ(check("studio/src/acting/a.tsx", "import type {\n  B,\n} from '../sim/b';\n"),
            "studio/src/acting/a.tsx:3: studio/src/acting must not use studio/src/sim\n");
  EXPECT_EQ(check("studio/src/base/deep/a.ts", "const b = lazy(() => import('../../graph/b'));\n"),
            "studio/src/base/deep/a.ts:1: studio/src/base must not use studio/src/graph\n");
  EXPECT_EQ(check("studio/src/graph/a.ts", "export * from '../main';\n"),
            "studio/src/graph/a.ts:1: studio/src/graph must not use studio/src/\n");
  EXPECT_EQ(check("studio/src/nowhere/a.ts", ""),
            "studio/src/nowhere/a.ts:1: studio/src/nowhere is not in floors.txt\n");
  EXPECT_EQ(
      check("studio/src/graph/a.ts", "import '../sim/a.css';\nimport { b } from './b';\nimport c from 'react';\n"), "");
  EXPECT_EQ(check("studio/src/main.ts", "import { b } from './graph/b';\n"), "");
  EXPECT_EQ(check("studio/tests/a.test.ts", "import { b } from '../src/graph/b';\n"), "");
}

TEST(CheckLength, CountsLines) {
  EXPECT_EQ(told(check_length("a.cpp", "1\n2\n3\n", 3)), "");
  EXPECT_EQ(told(check_length("a.cpp", "1\n2\n3\n4\n", 3)), "a.cpp:4: has 4 lines; split it, the limit is 3\n");
}

TEST(CheckFunctions, CountsLinesOfBodiesWhereverTheyStand) {
  const auto lines = [](const char* text) {
    std::string found;
    for (const Finding& finding : check_functions("a.cpp", text, 2)) found += std::to_string(finding.line) + " ";
    return found;
  };
  EXPECT_EQ(lines("void f() {\n}\n"), "");
  EXPECT_EQ(lines("#include <a>\n#include \"b.h\"\n\nnamespace a {\nnamespace {\nint f() {\n  return 1;\n}\n}\n}\n"),
            "6 ");
  EXPECT_EQ(lines("namespace a {\nint f(int a,\n      int b) {\n  return a;\n}\n}\n"), "3 ");
  EXPECT_EQ(lines("class A : public B<int (*)()> {\n public:\n  A() : b_{1}, c_(2) {\n    b();\n  }\n};\n"), "3 ");
  EXPECT_EQ(lines("A f(B = {}) const noexcept {\n  g([] {\n    h();\n  });\n}\n"), "1 ") << "not the lambda as well";
  EXPECT_EQ(lines("A a = {\n  1,\n};\nA b{\n  f(1),\n};\nenum class C {\n  kOne,\n};\nauto d = e(A{\n1,\n});\n"), "");
  EXPECT_EQ(lines("// f() {\nvoid f() { g(\"{\"); }\nint x;\n"), "");
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
