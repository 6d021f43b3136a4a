#include "ganglion/config/outline.h"

#include <algorithm>

namespace ganglion::config {

const Asked* Outline::find(std::string_view key) const noexcept {
  const auto found = std::find_if(keys_.begin(), keys_.end(), [&](const Key& known) { return known.name == key; });
  return found != keys_.end() ? &found->asked : nullptr;
}

Asked& Outline::ask(std::string_view key, Asked asked) {
  for (Key& known : keys_) {
    if (known.name != key) continue;
    known.asked.required = known.asked.required || asked.required;
    return known.asked;
  }
  return keys_.emplace_back(Key{std::string(key), std::move(asked)}).asked;
}

}  // namespace ganglion::config
