#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/tree/source.h"

/// What the compiler does not hold the tree to: the order of its layers, sizes, what tick code may call.
namespace ganglion::tree {

/// The order of the folders below ganglion/, earliest first; folders of one layer stand beside each other.
using Layers = std::vector<std::vector<std::string>>;

/// The one list there is for C++: GANGLION_LAYERS in the text of cmake/GanglionTargets.cmake. Empty if it is not there.
Layers parse_layers(std::string_view cmake_text);

/// The one list there is for the studio's page, studio/src/floors.txt: a floor a line, folders on it parted by "|",
/// what follows "#" is for readers.
Layers parse_floors(std::string_view text);

/// Includes of a layer that this file's own must not know. Tests may: they link what they need and nobody links them.
Findings check_includes(const std::string& file, std::string_view text, const Layers& layers);

/// Imports of a file below studio/src that lead to a folder on its own floor or above it. What lies in studio/src
/// itself starts the page and may use all of it.
Findings check_floors(const std::string& file, std::string_view text, const Layers& floors);

/// Longer than a reader takes in.
Findings check_length(const std::string& file, std::string_view text, int most_lines);

/// Functions, those in classes too, that take more lines from where their body begins to where it ends; lambdas count with
/// the function that they stand in.
Findings check_functions(const std::string& file, std::string_view text, int most_lines);

/// Whether a file runs inside ticks, where the same bits must come out on every machine.
bool is_tick_code(const std::string& file);

/// Calls to libm, whose last bit differs between machines, to clocks and to chance that no seed governs.
Findings check_tick_calls(const std::string& file, std::string_view text);

/// Absolute paths of somebody's machine.
Findings check_machine_paths(const std::string& file, std::string_view text);

/// Folders below ganglion/ that hold a .cpp and are not tested: by a *_test.cpp of their own, by one that includes a
/// header of theirs, or by one named after them. What only serves tests, testing/, needs none.
Findings check_tests(const std::vector<std::string>& files,
                     const std::function<std::string(const std::string&)>& text_of);

}  // namespace ganglion::tree
