#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ganglion::grid {

/// The open list of an A* search over numbered nodes: a four-way heap that can lower the key of a node in place, so it
/// never holds a node twice and never allocates after it was made. Equal keys leave in the order of the nodes' numbers.
class OpenList {
 public:
  explicit OpenList(std::size_t nodes) : place_(nodes, kNew) { heap_.reserve(nodes); }

  void clear() noexcept { heap_.clear(); }
  /// A node is seen for the first time in this search.
  void meet(std::uint32_t node) noexcept { place_[node] = kNew; }
  /// Adds the node, or moves it up when its key has fallen.
  void push(std::uint32_t node, std::uint64_t key) noexcept {
    std::uint32_t at = place_[node];
    if (at == kNew) {
      at = static_cast<std::uint32_t>(heap_.size());
      heap_.push_back({});  // within what was reserved: each node is in the heap at most once
    }
    rise(at, {key, node});
  }
  /// The first node leaves and is closed.
  std::uint32_t pop() noexcept {
    const std::uint32_t first = heap_.front().node;
    const Entry last = heap_.back();
    heap_.pop_back();
    place_[first] = kClosed;
    if (!heap_.empty()) sink(last);
    return first;
  }
  bool empty() const noexcept { return heap_.empty(); }
  bool closed(std::uint32_t node) const noexcept { return place_[node] == kClosed; }

 private:
  static constexpr std::uint32_t kNew = 0xFFFFFFFF;
  static constexpr std::uint32_t kClosed = 0xFFFFFFFE;
  struct Entry {
    std::uint64_t key = 0;
    std::uint32_t node = 0;
    bool before(const Entry& other) const noexcept { return key != other.key ? key < other.key : node < other.node; }
  };

  void put(std::uint32_t at, const Entry& entry) noexcept {
    heap_[at] = entry;
    place_[entry.node] = at;
  }
  void rise(std::uint32_t at, const Entry& entry) noexcept {
    while (at > 0) {
      const std::uint32_t parent = (at - 1) / 4;
      if (!entry.before(heap_[parent])) break;
      put(at, heap_[parent]);
      at = parent;
    }
    put(at, entry);
  }
  void sink(const Entry& entry) noexcept {
    const auto size = static_cast<std::uint32_t>(heap_.size());
    std::uint32_t at = 0;
    for (std::uint32_t child = 1; child < size; child = 4 * at + 1) {
      const std::uint32_t end = child + 4 < size ? child + 4 : size;
      std::uint32_t least = child;
      for (std::uint32_t other = child + 1; other < end; ++other) {
        if (heap_[other].before(heap_[least])) least = other;
      }
      if (!heap_[least].before(entry)) break;
      put(at, heap_[least]);
      at = least;
    }
    put(at, entry);
  }

  std::vector<Entry> heap_;
  std::vector<std::uint32_t> place_;  ///< Of each node: its index in the heap, or kNew, or kClosed.
};

}  // namespace ganglion::grid
