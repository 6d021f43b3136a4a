#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Reading the sources: which there are, what they say, whom they name.
namespace ganglion::tree {

/// Something that must not be, as "file:line: what". Paths are relative to the root of the sources.
struct Finding {
  std::string file;
  int line = 0;
  std::string what;
  std::string text() const;
};
using Findings = std::vector<Finding>;

/// One file names another. Both are relative to the root of the sources; `to` is as it is written, so that of a
/// TypeScript file it has no extension.
struct Import {
  std::string from;
  int line = 0;
  std::string to;
};
using Imports = std::vector<Import>;

/// Of C++ the quoted includes, which are written from the root; of TypeScript whatever is imported by a relative path.
Imports imports_of(const std::string& file, std::string_view text);

std::vector<std::string> lines_of(std::string_view text);

/// The same text with comments and the contents of strings and characters blanked, line ends kept.
std::string code_of(std::string_view text);

/// The files people wrote: everything but what builds and tools leave behind. Relative to `root`, sorted.
std::vector<std::string> source_files(const std::filesystem::path& root);

bool is_cpp(const std::string& file);

/// Tests, and what only serves tests.
bool is_test(const std::string& file);

/// "a/b" of "a/b/c.h".
std::string folder_of(const std::string& file);
/// "c.h" of "a/b/c.h".
std::string name_of(const std::string& file);

}  // namespace ganglion::tree
