#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "ganglion/experience/store.h"

namespace ganglion {

/// A list whose elements keep their memory when it is emptied.
template <class T>
class Reused {
 public:
  void clear() noexcept { used_ = 0; }
  T& add() {
    if (used_ == all_.size()) all_.emplace_back();
    return all_[used_++];
  }
  std::span<const T> items() const noexcept { return {all_.data(), used_}; }

 private:
  std::vector<T> all_;
  std::size_t used_ = 0;
};

/// Which generation of each part was handed over last, component by component.
using HandedParts = std::vector<std::map<std::string, std::uint64_t, std::less<>>>;

/// What components have learned, copied raw at one moment. Used again and again, so that copying takes no memory.
class Handover {
 public:
  /// Copies the parts that are not as they were handed over last, and notes which ones are there at all. `handed` is
  /// brought up to date.
  void take(std::span<const LearningComponent> learners, HandedParts& handed);
  /// As the store takes it: each part in its stored form.
  std::vector<ComponentUpdate> encoded() const;

 private:
  struct Part {
    std::string name;
    std::vector<std::byte> raw;
  };
  struct Component {
    std::string component, kind;
    std::uint32_t version = 0;
    Encode encode = nullptr;
    std::vector<RestsOn> rests_on;
    Reused<std::string> present;
    Reused<Part> changed;
  };
  Reused<Component> components_;
};

/// Whether any part was changed, added or lost since it was handed over.
bool anything_new(std::span<const LearningComponent> learners, const HandedParts& handed);

}  // namespace ganglion
