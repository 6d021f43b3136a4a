#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace ganglion {

inline constexpr int kDeepestJson = 64;

/// Shows `see` the characters of a JSON text that stand outside its strings, until it says no. False if it did.
template <class See>
bool all_outside_strings(std::string_view json, See see) {
  bool quoted = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (c == '"') quoted = !quoted;
    if (quoted && c == '\\') ++i;
    if (!quoted && !see(c)) return false;
  }
  return true;
}

/// Whether lists and objects of a JSON text lie in each other at most `most` deep. To be asked before the text is read:
/// a copy of what was read takes stack for every level.
inline bool json_nests_within(std::string_view json, int most) noexcept {
  int depth = 0;
  return all_outside_strings(json, [&](char c) {
    if (c == ']' || c == '}') --depth;
    return (c != '[' && c != '{') || ++depth <= most;
  });
}

/// How often keys may be compared while a JSON text is read: an object of 20,000 keys takes so many.
inline constexpr std::size_t kMostKeyLooks = 200'000'000;

/// Whether the objects of a JSON text have so few keys that a reader that keeps them in order, and so compares each
/// with all before it, is done in a moment.
inline bool json_has_few_keys(std::string_view json) {
  std::vector<std::size_t> keys(1);  // of each object that is open
  std::size_t looks = 0;
  return all_outside_strings(json, [&](char c) {
    if (c == '{') keys.push_back(0);
    if (c == '}' && keys.size() > 1) keys.pop_back();
    return c != ':' || (looks += keys.back()++) <= kMostKeyLooks;
  });
}

}  // namespace ganglion
