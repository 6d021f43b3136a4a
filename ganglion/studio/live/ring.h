#pragma once

#include <atomic>
#include <cstddef>
#include <utility>
#include <vector>

namespace ganglion::studio {

/// A bounded queue between one thread that writes and one that reads; neither ever waits for the other.
template <class T>
class Ring {
 public:
  /// `room` of the same make each: slots are written over, not made anew.
  Ring(std::size_t capacity, const T& make) : slots_(capacity + 1, make) {}

  /// The slot to fill, or null where the reader is behind; push() then hands it over.
  T* free_slot() noexcept {
    const std::size_t at = head_.load(std::memory_order_relaxed);
    return next(at) == tail_.load(std::memory_order_acquire) ? nullptr : &slots_[at];
  }
  void push() noexcept { head_.store(next(head_.load(std::memory_order_relaxed)), std::memory_order_release); }

  /// The oldest, or null; pop() then gives the slot back.
  T* front() noexcept {
    const std::size_t at = tail_.load(std::memory_order_relaxed);
    return at == head_.load(std::memory_order_acquire) ? nullptr : &slots_[at];
  }
  void pop() noexcept { tail_.store(next(tail_.load(std::memory_order_relaxed)), std::memory_order_release); }

 private:
  std::size_t next(std::size_t at) const noexcept { return at + 1 == slots_.size() ? 0 : at + 1; }

  std::vector<T> slots_;
  alignas(64) std::atomic<std::size_t> head_ = 0;
  alignas(64) std::atomic<std::size_t> tail_ = 0;
};

}  // namespace ganglion::studio
