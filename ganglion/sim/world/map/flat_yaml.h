#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"

namespace ganglion::sim {

/// One `key: value` line. A value is one word or text, or a list in brackets.
struct YamlEntry {
  std::string key;
  std::vector<std::string> items;  ///< One item for a plain value.
  bool is_list = false;
  Place place;  ///< Of the value.
};

/// The flat part of YAML that ROS map files are written in: `key: value` lines, `[a, b, c]`, lists of `- item` lines,
/// 'quotes' and "quotes", # comments, `---`. Anything nested, and keys given twice, fail with Syntax at their place;
/// TooLarge beyond 64 KiB or 100 keys.
Result<std::vector<YamlEntry>> parse_flat_yaml(std::string_view text, const std::string& file_name);

}  // namespace ganglion::sim
