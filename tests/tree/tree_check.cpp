#include "tests/tree/tree_check.h"

#include <algorithm>
#include <array>
#include <optional>
#include <regex>
#include <set>

namespace ganglion::tree {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// "sim" of "ganglion/sim/world/world.cpp"; "" of a file elsewhere.
std::string area_of(const std::string& file) {
  static const std::regex kArea("^ganglion/([^/]+)/.*");
  std::smatch match;
  return std::regex_match(file, match, kArea) ? match[1].str() : "";
}

std::optional<std::size_t> rank_of(const std::string& area, const Layers& layers) {
  for (std::size_t rank = 0; rank < layers.size(); ++rank) {
    if (std::count(layers[rank].begin(), layers[rank].end(), area) > 0) return rank;
  }
  return std::nullopt;
}

bool is_test(const std::string& file) {
  return file.ends_with("_test.cpp") || file.find("/testing/") != std::string::npos;
}

bool is_cpp(const std::string& file) { return file.ends_with(".cpp") || file.ends_with(".h"); }

std::string folder_of(const std::string& file) { return file.substr(0, file.rfind('/')); }
std::string name_of(const std::string& file) { return file.substr(file.rfind('/') + 1); }

}  // namespace

std::string Finding::text() const { return file + ":" + std::to_string(line) + ": " + what; }

Layers parse_layers(std::string_view cmake_text) {
  constexpr std::string_view kStart = "set(GANGLION_LAYERS";
  const std::size_t start = cmake_text.find(kStart);
  if (start == std::string_view::npos) return {};
  const std::string list(cmake_text.substr(start, cmake_text.find(')', start) - start));
  Layers layers;
  static const std::regex kQuoted("\"([^\"]+)\"");
  for (std::sregex_iterator at(list.begin(), list.end(), kQuoted), end; at != end; ++at) {
    const std::string layer = (*at)[1].str();
    static const std::regex kName("[^|]+");
    std::vector<std::string> beside;
    for (std::sregex_iterator name(layer.begin(), layer.end(), kName); name != end; ++name)
      beside.push_back(name->str());
    layers.push_back(std::move(beside));
  }
  return layers;
}

Findings check_includes(const std::string& file, std::string_view text, const Layers& layers) {
  const std::string mine = area_of(file);
  if (mine.empty() || !is_cpp(file) || is_test(file)) return {};
  const auto my_rank = rank_of(mine, layers);
  if (!my_rank) return {{file, 1, "ganglion/" + mine + " is not in GANGLION_LAYERS"}};
  Findings findings;
  static const std::regex kInclude("^\\s*#\\s*include\\s*\"(ganglion/([^/\"]+)/[^\"]*)\".*");
  const std::vector<std::string> lines = lines_of(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::smatch match;
    if (!std::regex_match(lines[i], match, kInclude)) continue;
    const std::string theirs = match[2].str();
    const auto their_rank = rank_of(theirs, layers);
    if (theirs == mine || (their_rank && *their_rank < *my_rank)) continue;
    findings.push_back({file, static_cast<int>(i) + 1, "ganglion/" + mine + " must not use ganglion/" + theirs});
  }
  return findings;
}

Findings check_length(const std::string& file, std::string_view text, int most_lines) {
  const auto lines = static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  if (!is_cpp(file) || lines <= most_lines) return {};
  return {
      {file, lines, "has " + std::to_string(lines) + " lines; split it, the limit is " + std::to_string(most_lines)}};
}

bool is_tick_code(const std::string& file) {
  static const std::set<std::string> kAreas = {"units", "geometry", "random", "module",       "fuzzy", "grid",
                                               "goal",  "sensing",  "acting", "coordination", "sim",   "plant"};
  if (!is_cpp(file) || is_test(file)) return false;
  return kAreas.contains(area_of(file)) || file == "ganglion/graph/controller.cpp";
}

Findings check_tick_calls(const std::string& file, std::string_view text) {
  static const std::regex kLibm(
      "(^|[^\\w.:>])(std::|::)?(sin|cos|tan|asin|acos|atan|atan2|sincos|sinh|cosh|tanh|asinh|acosh|atanh|exp|exp2|"
      "expm1|"
      "log|log2|log10|log1p|pow|hypot|cbrt|erf|erfc|tgamma|lgamma)[fl]?\\s*\\(");
  static const std::regex kOutside(
      "std::(chrono|rand\\b|random_device|mt19937|minstd_rand|default_random_engine|time\\b|clock\\b|\\w+_"
      "distribution)");
  Findings findings;
  const std::vector<std::string> lines = lines_of(code_of(text));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::smatch match;
    if (std::regex_search(lines[i], match, kLibm)) {
      findings.push_back(
          {file, static_cast<int>(i) + 1,
           match[3].str() + "() of libm; use ganglion/math/functions.h, which gives the same bits everywhere"});
    }
    if (std::regex_search(lines[i], match, kOutside)) {
      findings.push_back(
          {file, static_cast<int>(i) + 1, match[0].str() + " in tick code: time and chance are arguments"});
    }
  }
  return findings;
}

Findings check_machine_paths(const std::string& file, std::string_view text) {
  // Put together here, so that this file does not find itself.
  static const std::regex kPath(std::string("(^|[^\\w.~*-])/") + "(work|home|root|tmp|Users)/");
  Findings findings;
  const std::vector<std::string> lines = lines_of(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].size() > 4096 || !std::regex_search(lines[i], kPath)) continue;
    findings.push_back({file, static_cast<int>(i) + 1, "names a path of one machine"});
  }
  return findings;
}

Findings check_tests(const std::vector<std::string>& files,
                     const std::function<std::string(const std::string&)>& text_of) {
  std::set<std::string> with_sources, tested, names;
  static const std::regex kInclude("#include \"(ganglion/[^\"]*)/[^/\"]*\"");
  for (const std::string& file : files) {
    if (area_of(file).empty() || !file.ends_with(".cpp")) continue;
    if (!file.ends_with("_test.cpp")) {
      if (!is_test(file)) with_sources.insert(folder_of(file));
      continue;
    }
    tested.insert(folder_of(file));
    names.insert(name_of(file));
    const std::string text = text_of(file);
    for (std::sregex_iterator at(text.begin(), text.end(), kInclude), end; at != end; ++at)
      tested.insert((*at)[1].str());
  }
  Findings findings;
  for (const std::string& folder : with_sources) {
    if (tested.contains(folder) || names.contains(name_of(folder) + "_test.cpp")) continue;
    findings.push_back({folder, 0, "has sources and no test"});
  }
  return findings;
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

}  // namespace ganglion::tree
