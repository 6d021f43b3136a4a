#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ganglion/application/description.h"
#include "ganglion/base/files.h"
#include "ganglion/base/sentence.h"
#include "ganglion/config/source/source_map.h"
#include "ganglion/graph/model.h"

namespace ganglion::studio {

/// Where a text lives: paths in it are relative to its file, and nothing outside of the folder is read.
struct DocumentPlace {
  std::filesystem::path file;
  std::filesystem::path folder;
};

/// A problem of a drawing, and what to point at.
struct DrawingProblem {
  Error error;
  std::string component;  ///< "" = of the whole.
  std::string key;        ///< "trigger_range_m", "in.left"; "" = of the whole component.
  std::string port() const { return key.starts_with("in.") ? key.substr(3) : std::string(); }
};

/// A controller's text, understood as far as it can be.
struct Drawing {
  config::SourceMap map;
  std::vector<config::ItemSource> sources;
  ControllerModel unresolved;  ///< As the file says it.
  ControllerModel model;       ///< Held against the robot, where one is known.
  std::optional<Description> robot;
  std::filesystem::path robot_path;  ///< From the folder on; empty where it is outside.
  std::map<std::string, std::pair<double, double>> layout;
  std::vector<DrawingProblem> problems;  ///< In the order of the lines.
};

/// Always opens. `files` reads what the text names.
Drawing open_drawing(std::string_view text, const DocumentPlace& place, FileReader& files);
/// The same with other kinds than the program's.
Drawing open_drawing(std::string_view text, const DocumentPlace& place, FileReader& files, const KindList& kinds);

/// For the page: docs/studio_api.md, Model. Messages in the given language. Written straight into a text: a tree of
/// values takes longer than all the checks.
std::string drawing_json(const Drawing& drawing, std::string_view text, Language language);

}  // namespace ganglion::studio
