#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/graph/testing/kinds.h"
#include "ganglion/studio/document/drawing.h"

// A drawing whose parameters name files; the kind Ruled has an output for each line of its own.
namespace ganglion::studio {
namespace {

using Json = nlohmann::ordered_json;

class DrawnFileParameters : public FolderTest {
 protected:
  void put(const std::string& name, const std::string& text) const { ASSERT_TRUE(write_file(folder_ / name, text)); }
  /// As the page is told it, of a text that is not saved.
  Json drawn(const std::string& rules) const {
    const std::string text = "format = 1\n[[sensing]]\nid = \"x\"\nkind = \"Ruled\"\n" + rules;  // line 5
    DiskFiles files;
    const DocumentPlace place{folder_ / "sub/controller.toml", folder_};
    return Json::parse(drawing_json(open_drawing(text, place, files, testing::kinds()), text, Language::English));
  }
  static Json problem_of(const Json& model, const std::string& key) {
    for (const Json& one : model["problems"]) {
      if (one["key"] == key) return one;
    }
    return {};
  }
};

TEST_F(DrawnFileParameters, AreReadFromTheFolderOfTheDrawing) {
  put("sub/rules.txt", "near 2\nfar 3\n");
  const Json model = drawn("rules = \"rules.txt\"\n");
  EXPECT_TRUE(problem_of(model, "rules").is_null());
  const Json& component = model["components"][0];
  EXPECT_EQ(component["outputs"][0]["name"], "near");
  EXPECT_EQ(component["outputs"][1]["name"], "far");
  EXPECT_EQ(component["parameters"][0]["value"], "rules.txt") << component.dump();
}

TEST_F(DrawnFileParameters, ThatAreNotThereAreProblemsOfTheirField) {
  const Json problem = problem_of(drawn("rules = \"none.txt\"\n"), "rules");
  EXPECT_EQ(problem["component"], "x");
  EXPECT_EQ(problem["line"], 5);
  EXPECT_EQ(problem["code"], "NotFound");
}

TEST_F(DrawnFileParameters, ErrorsInThemAreToldInTheDrawing) {
  put("sub/rules.txt", "near 2\nfar away\n");
  const Json problem = problem_of(drawn("rules = \"rules.txt\"\n"), "rules");
  EXPECT_EQ(problem["message"], "rules.txt, line 2: x: no number");
  EXPECT_EQ(problem["component"], "x");
  EXPECT_EQ(problem["line"], 5);
}

}  // namespace
}  // namespace ganglion::studio
