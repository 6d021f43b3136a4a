#pragma once

#include <compare>
#include <map>
#include <memory>
#include <mutex>
#include <typeindex>

namespace ganglion::sim {

/// What has been worked out about one ground, kept for all that ask again, from any thread: thousands of short runs
/// share one ground.
class Findings {
 public:
  /// The finding of that type and those two numbers; `make()` works it out the first time, while others wait.
  template <class Finding, class Make>
  std::shared_ptr<const Finding> get(double a, double b, Make make) {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<const void>& kept = kept_[Key{std::type_index(typeid(Finding)), a, b}];
    if (kept == nullptr) kept = std::make_shared<const Finding>(make());
    return std::static_pointer_cast<const Finding>(kept);
  }

 private:
  struct Key {
    std::type_index type;
    double a;
    double b;
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  std::mutex mutex_;
  std::map<Key, std::shared_ptr<const void>> kept_;
};

}  // namespace ganglion::sim
