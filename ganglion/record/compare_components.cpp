#include "ganglion/record/compare_components.h"

#include <map>

namespace ganglion {

DigestComparison compare_components(const RunOutcome& first, const RunOutcome& second) {
  const std::map<std::string, std::string> one(first.component_digests.begin(), first.component_digests.end());
  const std::map<std::string, std::string> other(second.component_digests.begin(), second.component_digests.end());
  DigestComparison found;
  for (const auto& [name, digest] : one) {
    const auto twin = other.find(name);
    if (twin == other.end()) {
      found.only_first.push_back(name);
    } else {
      (twin->second == digest ? found.same : found.different).push_back(name);
    }
  }
  for (const auto& [name, digest] : other) {
    if (!one.contains(name)) found.only_second.push_back(name);
  }
  return found;
}

}  // namespace ganglion
