#include "ganglion/studio/document/drawing.h"

#include <algorithm>
#include <cmath>

#include "ganglion/config/source/tolerant.h"
#include "ganglion/graph/order.h"
#include "ganglion/kinds/applications.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/studio/document/component_lists.h"

namespace ganglion::studio {
namespace {

namespace fs = std::filesystem;

bool inside(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(file, error);
  const fs::path root = fs::weakly_canonical(folder, error);
  return std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first == root.end();
}

std::optional<Description> load_robot(FileReader& files, const ControllerModel& model, const config::Value& root,
                                      const DocumentPlace& place, Problems& problems) {
  const config::Value* named = root.find("robot");
  const Place where = named != nullptr ? named->place() : Place{place.file.string(), 1, 1};
  if (model.robot.empty()) {
    problems.add(where, ErrorCode::MissingKey,
                 {"robot is missing: name the robot.toml it is drawn for",
                  "falta robot: nombre el robot.toml para el que está dibujado"});
    return std::nullopt;
  }
  if (!inside(model.robot, place.folder)) {
    problems.add(where, ErrorCode::NotFound,
                 {"robot lies outside of the folder that the studio was started for",
                  "robot está fuera de la carpeta para la que se inició el estudio"});
    return std::nullopt;
  }
  Problems in_robot;
  std::optional<Description> robot;
  if (const auto file = files.open("robot", model.robot.string(), -1, config::kMaxBytes)) {
    robot = read_description(files, *file, {}, in_robot);
  } else {
    in_robot.add(file.error());
  }
  if (!in_robot.empty()) {
    const Error first = in_robot.sorted().front();
    problems.add(where, first.code,
                 {"the robot cannot be read: line {}: {}", "no se puede leer el robot: línea {}: {}"}, first.place.line,
                 first.what);
    return std::nullopt;
  }
  return robot;
}

void read_layout(const config::Value& root, Drawing& drawing) {
  const config::Value* layout = root.find("layout");
  if (layout == nullptr || layout->table() == nullptr) return;
  const auto number = [](const config::Value& value) -> std::optional<double> {
    if (const auto* whole = value.integer()) return static_cast<double>(*whole);
    if (const auto* real = value.real()) return std::isfinite(*real) ? std::optional(*real) : std::nullopt;
    return std::nullopt;
  };
  for (const auto& [id, value] : *layout->table()) {
    const config::Array* pair = value.array();
    if (pair == nullptr || pair->size() != 2) continue;
    const auto x = number((*pair)[0]), y = number((*pair)[1]);
    if (x && y) drawing.layout[id] = {*x, *y};
  }
}

/// The component on each line, and the key.
struct Owner {
  std::string component;
  std::string key;
};

/// What stands on the lines of the text, by its first line.
std::map<int, Owner> owners_of(const Drawing& drawing) {
  std::map<int, Owner> owners;
  for (const config::SectionSource& section : drawing.map.sections) {
    if (section.line > 0) owners[section.line] = {};
    for (const config::MemberSource& member : section.members) owners[member.line] = {"", member.key};
  }
  for (const config::ItemSource& source : drawing.sources) {
    for (const std::size_t index : source.sections) {
      const config::SectionSource& section = drawing.map.sections[index];
      const std::string prefix = source.prefix(drawing.map, index);
      owners[section.line] = {source.id, ""};
      for (const config::MemberSource& member : section.members) {
        Owner& owner = owners[member.line];
        if (!member.inline_key.empty() && !owner.component.empty()) continue;
        owner = {source.id, member.key == "id" ? "" : prefix + member.key};
      }
    }
  }
  return owners;
}

/// The input that is not wired stands on no line of its own.
std::string missing_input(const Error& error) {
  const std::string& part = error.subject.part;
  return part.starts_with("in.") ? part : std::string();
}

/// An error in a file that a parameter names is pointed at where the parameter stands, else where its component does.
void bring_home(Error& error, const std::map<int, Owner>& owners, const std::string& document) {
  const std::string file = fs::path(error.place.file).filename().string();
  error.what = error.place.line > 0 ? say({"{}, line {}: {}", "{}, línea {}: {}"}, file, error.place.line, error.what)
                                    : say({"{}: {}", "{}: {}"}, file, error.what);
  error.place = {document};
  for (const auto& [line, owner] : owners) {
    const bool here = owner.component == error.subject.component && !owner.component.empty();
    if (here && (error.place.line == 0 || owner.key == error.subject.part)) error.place.line = line;
  }
}

void assign(Drawing& drawing, const Problems& problems, const std::string& document) {
  const std::map<int, Owner> owners = owners_of(drawing);
  for (Error error : problems.sorted()) {
    if (error.place.file != document) bring_home(error, owners, document);
    DrawingProblem problem{error, "", ""};
    auto found = owners.upper_bound(error.place.line);
    if (error.place.line > 0 && found != owners.begin()) {
      --found;
      problem.component = found->second.component;
      problem.key = found->second.key;
    }
    if (problem.key.empty() && !problem.component.empty()) problem.key = missing_input(error);
    drawing.problems.push_back(std::move(problem));
  }
}

}  // namespace

Drawing open_drawing(std::string_view text, const DocumentPlace& place, FileReader& files) {
  return open_drawing(text, place, files, controller_kinds());
}

Drawing open_drawing(std::string_view text, const DocumentPlace& place, FileReader& files, const KindList& kinds) {
  Drawing drawing;
  drawing.map = config::map_source(text);
  drawing.sources = config::items_of(drawing.map, text, kComponentLists);
  Problems problems;
  const config::Value root = config::parse_tolerantly(text, drawing.map, place.file.string(), problems);
  files.hold("controller", place.file, std::string(text));
  drawing.unresolved = read_controller(root, kinds, problems, &files);
  read_layout(root, drawing);
  std::error_code error;
  if (!drawing.unresolved.robot.empty() && inside(drawing.unresolved.robot, place.folder)) {
    drawing.robot_path = fs::relative(drawing.unresolved.robot, place.folder, error);
  }
  drawing.robot = load_robot(files, drawing.unresolved, root, place, problems);
  drawing.model = drawing.unresolved;
  if (drawing.robot) {
    resolve(drawing.model, *drawing.robot, problems);
    order(drawing.model, problems);
  }
  assign(drawing, problems, place.file.string());
  return drawing;
}

}  // namespace ganglion::studio
