#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// What the compiler does not hold the tree to: the order of its layers, sizes, what tick code may call.
namespace ganglion::tree {

/// Something that must not be, as "file:line: what". Paths are relative to the root of the sources.
struct Finding {
  std::string file;
  int line = 0;
  std::string what;
  std::string text() const;
};
using Findings = std::vector<Finding>;

/// The order of the folders below ganglion/, earliest first; folders of one layer stand beside each other.
using Layers = std::vector<std::vector<std::string>>;

/// The one list there is: GANGLION_LAYERS in the text of cmake/GanglionTargets.cmake. Empty if it is not there.
Layers parse_layers(std::string_view cmake_text);

/// Includes of a layer that this file's own must not know. Tests may: they link what they need and nobody links them.
Findings check_includes(const std::string& file, std::string_view text, const Layers& layers);

/// Longer than a reader takes in.
Findings check_length(const std::string& file, std::string_view text, int most_lines);

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

/// The same text with comments and the contents of strings and characters blanked, line ends kept.
std::string code_of(std::string_view text);

/// The files people wrote: everything but what builds and tools leave behind. Relative to `root`, sorted.
std::vector<std::string> source_files(const std::filesystem::path& root);

}  // namespace ganglion::tree
