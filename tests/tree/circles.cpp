#include "tests/tree/circles.h"

#include <algorithm>
#include <utility>

namespace ganglion::tree {
namespace {

std::set<std::string> reached_from(const std::string& room, const Arrows& arrows) {
  std::set<std::string> reached;
  std::vector<std::string> open = {room};
  while (!open.empty()) {
    const auto at = arrows.find(open.back());
    open.pop_back();
    if (at == arrows.end()) continue;
    for (const std::string& next : at->second)
      if (reached.insert(next).second) open.push_back(next);
  }
  return reached;
}

/// Of what lies in `parent`: "parent/." for its own files, "parent/a" for all below its folder a; "" of others.
std::string room_in(const std::string& parent, const std::string& file) {
  const std::string folder = folder_of(file);
  if (folder == parent) return parent + "/.";
  if (!folder.starts_with(parent + "/")) return "";
  return folder.substr(0, folder.find('/', parent.size() + 1));
}

}  // namespace

std::vector<std::vector<std::string>> circles_of(const Arrows& arrows) {
  std::map<std::string, std::set<std::string>> reached;
  for (const auto& [room, _] : arrows) reached[room] = reached_from(room, arrows);
  std::set<std::vector<std::string>> circles;  // each is found from all of its rooms
  for (const auto& [room, others] : reached) {
    std::vector<std::string> circle;
    for (const std::string& other : others)
      if (const auto back = reached.find(other); back != reached.end() && back->second.contains(room))
        circle.push_back(other);
    if (circle.size() > 1) circles.insert(std::move(circle));
  }
  return {circles.begin(), circles.end()};
}

Findings check_circles(const Imports& imports, const RoomOf& room_of) {
  Arrows arrows;
  std::map<std::pair<std::string, std::string>, const Import*> first;
  for (const Import& import : imports) {
    const std::string from = room_of(import.from), to = room_of(import.to);
    if (from.empty() || to.empty() || from == to) continue;
    arrows[from].insert(to);
    first.try_emplace({from, to}, &import);
  }
  Findings findings;
  for (const std::vector<std::string>& circle : circles_of(arrows)) {
    const auto is_part = [&](const std::string& room) {
      return std::binary_search(circle.begin(), circle.end(), room);
    };
    for (const auto& [arrow, import] : first) {
      const auto& [from, to] = arrow;
      if (!is_part(from) || !is_part(to)) continue;
      findings.push_back({import->from, import->line, from + " and " + to + " are in a circle, by " + import->to});
    }
  }
  return findings;
}

Findings check_folder_circles(const Imports& imports) {
  std::set<std::string> parents;
  for (const Import& import : imports) {
    for (std::string folder = import.from; folder.find('/') != std::string::npos;)
      parents.insert(folder = folder_of(folder));
  }
  Findings findings;
  for (const std::string& parent : parents) {
    const Findings found = check_circles(imports, [&](const std::string& file) { return room_in(parent, file); });
    findings.insert(findings.end(), found.begin(), found.end());
  }
  return findings;
}

Findings check_file_circles(const Imports& imports) {
  return check_circles(imports, [](const std::string& file) {
    return file.ends_with(".ts") || file.ends_with(".tsx") ? file.substr(0, file.rfind('.')) : file;
  });
}

}  // namespace ganglion::tree
