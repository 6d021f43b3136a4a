#include "tests/tree/tree_check.h"

#include <algorithm>
#include <array>
#include <optional>
#include <regex>
#include <set>

#include "tests/tree/source.h"

namespace ganglion::tree {
namespace {

const std::string kSources = "ganglion/";
const std::string kPage = "studio/src/";

/// "sim" of "ganglion/sim/world/world.cpp" below "ganglion/"; "" of a file elsewhere, or of one that lies in no folder.
std::string folder_below(const std::string& root, const std::string& file) {
  if (!file.starts_with(root)) return "";
  const std::size_t end = file.find('/', root.size());
  return end == std::string::npos ? "" : file.substr(root.size(), end - root.size());
}

std::string area_of(const std::string& file) { return folder_below(kSources, file); }

std::optional<std::size_t> rank_of(const std::string& area, const Layers& layers) {
  for (std::size_t rank = 0; rank < layers.size(); ++rank) {
    if (std::count(layers[rank].begin(), layers[rank].end(), area) > 0) return rank;
  }
  return std::nullopt;
}

/// Imports from below `root` that lead to a folder beside the file's own or above it.
Findings against_order(const Imports& imports, const std::string& root, const Layers& layers) {
  Findings findings;
  for (const Import& import : imports) {
    if (!import.to.starts_with(root)) continue;
    const std::string mine = folder_below(root, import.from), theirs = folder_below(root, import.to);
    const auto my_rank = rank_of(mine, layers), their_rank = rank_of(theirs, layers);
    if (theirs == mine || (their_rank && *their_rank < *my_rank)) continue;
    findings.push_back({import.from, import.line, root + mine + " must not use " + root + theirs});
  }
  return findings;
}

enum class Brace { Scope, Function, Value };

/// What a brace opens after `head`, the words since the end of what stood before it.
Brace brace_after(const std::string& head) {
  static const std::regex kScope("^\\s*(namespace|class|struct|union|enum)\\b|\\bextern \"[^\"]*\"\\s*$");
  if (std::regex_search(head, kScope)) return Brace::Scope;
  const std::size_t last = head.find_last_not_of(" \n");
  const bool whole = std::count(head.begin(), head.end(), '(') == std::count(head.begin(), head.end(), ')');
  const bool called = whole && head.find('(') != std::string::npos;
  return called && std::string_view("=,").find(head[last]) == std::string_view::npos ? Brace::Function : Brace::Value;
}

}  // namespace

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

Layers parse_floors(std::string_view text) {
  Layers floors;
  for (std::string line : lines_of(text)) {
    line.erase(std::min(line.find('#'), line.size()));
    static const std::regex kName("[^|\\s]+");
    std::vector<std::string> beside;
    for (std::sregex_iterator name(line.begin(), line.end(), kName), end; name != end; ++name)
      beside.push_back(name->str());
    if (!beside.empty()) floors.push_back(std::move(beside));
  }
  return floors;
}

Findings check_includes(const std::string& file, std::string_view text, const Layers& layers) {
  const std::string mine = area_of(file);
  if (mine.empty() || !is_cpp(file) || is_test(file)) return {};
  if (!rank_of(mine, layers)) return {{file, 1, "ganglion/" + mine + " is not in GANGLION_LAYERS"}};
  return against_order(imports_of(file, text), kSources, layers);
}

Findings check_floors(const std::string& file, std::string_view text, const Layers& floors) {
  const std::string mine = folder_below(kPage, file);
  if (mine.empty()) return {};
  if (!rank_of(mine, floors)) return {{file, 1, kPage + mine + " is not in floors.txt"}};
  return against_order(imports_of(file, text), kPage, floors);
}

Findings check_length(const std::string& file, std::string_view text, int most_lines) {
  const auto lines = static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  if (!is_cpp(file) || lines <= most_lines) return {};
  return {
      {file, lines, "has " + std::to_string(lines) + " lines; split it, the limit is " + std::to_string(most_lines)}};
}

Findings check_functions(const std::string& file, std::string_view text, int most_lines) {
  if (!is_cpp(file)) return {};
  struct Open {
    Brace brace;
    int line;
  };
  static const std::regex kDirective("(^|\n)[ \\t]*#[^\n]*");
  const std::string code = std::regex_replace(code_of(text), kDirective, "$1");
  Findings findings;
  std::vector<Open> open;
  std::string head;
  int line = 1;
  for (const char c : code) {
    const bool outside = open.empty() || open.back().brace == Brace::Scope;
    if (c == '\n') ++line;
    if (c == '{') {
      open.push_back({outside ? brace_after(head) : Brace::Value, line});
      if (outside && open.back().brace != Brace::Value) head.clear();
    } else if (c == '}' && !open.empty()) {
      const int lines = line - open.back().line + 1;
      if (open.back().brace == Brace::Function && lines > most_lines)
        findings.push_back(
            {file, open.back().line,
             "a function of " + std::to_string(lines) + " lines; the limit is " + std::to_string(most_lines)});
      if (open.back().brace != Brace::Value) head.clear();
      open.pop_back();
    } else if (outside) {
      head = c == ';' ? "" : head + c;
    }
  }
  return findings;
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

}  // namespace ganglion::tree
