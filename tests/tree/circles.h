#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/tree/source.h"

/// Rooms that name each other in a circle: none of them can be read, tested or moved without the others.
namespace ganglion::tree {

/// Whom each room names.
using Arrows = std::map<std::string, std::set<std::string>>;

/// The rooms of each circle, sorted: from each of them the arrows lead to every other and back. A room that names
/// itself is none.
std::vector<std::vector<std::string>> circles_of(const Arrows& arrows);

/// The room that a file stands in; "" = in none that is looked at.
using RoomOf = std::function<std::string(const std::string& file)>;

/// Of every arrow that is part of a circle the first import that draws it.
Findings check_circles(const Imports& imports, const RoomOf& room_of);

/// Circles of folders. For every folder, what lies in it must be free of them: its own files, told as "folder/.", and
/// each folder in it with all that is below.
Findings check_folder_circles(const Imports& imports);

/// Circles of files; extensions do not count.
Findings check_file_circles(const Imports& imports);

}  // namespace ganglion::tree
