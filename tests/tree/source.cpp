#include "tests/tree/source.h"

#include <algorithm>
#include <regex>
#include <set>

namespace ganglion::tree {

std::string Finding::text() const { return file + ":" + std::to_string(line) + ": " + what; }

Imports imports_of(const std::string& file, std::string_view text) {
  static const std::regex kInclude("^\\s*#\\s*include\\s*\"([^\"]+)\".*");
  static const std::regex kImport("\\b(?:from|import)\\s*\\(?\\s*['\"](\\.[^'\"]*)['\"]");
  const bool cpp = is_cpp(file);
  if (!cpp && !file.ends_with(".ts") && !file.ends_with(".tsx")) return {};
  Imports imports;
  const std::vector<std::string> lines = lines_of(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::smatch match;
    if (!std::regex_search(lines[i], match, cpp ? kInclude : kImport)) continue;
    const std::filesystem::path written = match[1].str();
    const std::filesystem::path to = cpp ? written : (folder_of(file) / written).lexically_normal();
    imports.push_back({file, static_cast<int>(i) + 1, to.generic_string()});
  }
  return imports;
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string code_of(std::string_view text) {
  std::string code(text);
  const auto blank = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < std::min(to, code.size()); ++i) code[i] = code[i] == '\n' ? '\n' : ' ';
  };
  const auto past = [&](std::string_view closing, std::size_t from) {
    const std::size_t found = text.find(closing, from);
    return found == std::string_view::npos ? text.size() : found + closing.size();
  };
  const auto past_quote = [&](char quote, std::size_t at) {
    while (at < text.size() && text[at] != quote && text[at] != '\n') at += text[at] == '\\' ? 2 : 1;
    return std::min(at + 1, text.size());
  };
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = text.substr(at);
    std::size_t end = at + 1;
    if (rest.starts_with("//")) {
      end = std::min(text.find('\n', at), text.size());
      blank(at, end);
    } else if (rest.starts_with("/*")) {
      end = past("*/", at + 2);
      blank(at, end);
    } else if (rest.starts_with("R\"")) {
      const std::string closing = ")" + std::string(rest.substr(2, std::min(rest.find('('), rest.size()) - 2)) + "\"";
      end = past(closing, at + 2);
      blank(at, end);
    } else if (rest.front() == '"') {
      end = past_quote('"', at + 1);
      blank(at + 1, end - 1);
    } else if (rest.front() == '\'' && (at == 0 || !std::isalnum(static_cast<unsigned char>(text[at - 1])))) {
      end = past_quote('\'', at + 1);
      blank(at + 1, end - 1);
    }
    at = end;
  }
  return code;
}

std::vector<std::string> source_files(const std::filesystem::path& root) {
  static const std::set<std::string> kOthers = {"build", "node_modules", "dist", "runs"};
  static const std::set<std::string> kTexts = {"",       ".h",    ".cpp", ".c",   ".cmake", ".txt", ".md",   ".toml",
                                               ".ts",    ".tsx",  ".js",  ".mjs", ".py",    ".sh",  ".json", ".in",
                                               ".proto", ".html", ".css", ".yml", ".yaml",  ".fll"};
  std::vector<std::string> files;
  for (auto at = std::filesystem::recursive_directory_iterator(root); at != std::filesystem::end(at); ++at) {
    const std::string name = at->path().filename().string();
    if (at->is_directory()) {
      if (kOthers.contains(name) || (name.front() == '.' && name != ".ci")) at.disable_recursion_pending();
    } else if (at->is_regular_file() && name != ".git" && kTexts.contains(at->path().extension().string())) {
      files.push_back(std::filesystem::relative(at->path(), root).generic_string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool is_test(const std::string& file) {
  return file.ends_with("_test.cpp") || file.find("/testing/") != std::string::npos;
}

bool is_cpp(const std::string& file) { return file.ends_with(".cpp") || file.ends_with(".h"); }

std::string folder_of(const std::string& file) { return file.substr(0, file.rfind('/')); }
std::string name_of(const std::string& file) { return file.substr(file.rfind('/') + 1); }

}  // namespace ganglion::tree
