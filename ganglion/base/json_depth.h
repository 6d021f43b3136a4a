#pragma once

#include <string_view>

namespace ganglion {

inline constexpr int kDeepestJson = 64;

/// Whether lists and objects of a JSON text lie in each other at most `most` deep. To be asked before the text is read:
/// a copy of what was read takes stack for every level.
inline bool json_nests_within(std::string_view json, int most) noexcept {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (c == '"') quoted = !quoted;
    if (quoted && c == '\\') ++i;
    if (quoted) continue;
    if ((c == '[' || c == '{') && ++depth > most) return false;
    if (c == ']' || c == '}') --depth;
  }
  return true;
}

}  // namespace ganglion
