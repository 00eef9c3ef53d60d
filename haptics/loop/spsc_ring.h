#pragma once
// A bounded queue from one thread to one other. Wait-free on both sides: it never blocks and never allocates
// after it is built. All ticks arrive, in order, or push() says that one did not fit.
//
// After L. Lamport, "Specifying Concurrent Program Modules", ACM TOPLAS 5(2), 1983: each index has one
// writer.

#include <atomic>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace fulcrum {

template <class T>
class SpscRing {
  // Eigen's fixed-size types do not count as trivially copyable, though copying them is copying their bits. A
  // type that has nothing to destroy owns no memory: that is what keeps push() and pop() free of allocation.
  static_assert(std::is_trivially_destructible_v<T>);

public:
  explicit SpscRing(std::size_t capacity) : slots_(capacity + 1) {}

  // The producer's thread only. False: the ring is full and the value was not taken.
  bool push(const T& value) noexcept {
    const std::size_t write = write_.load(std::memory_order_relaxed);
    const std::size_t next = after(write);
    if (next == read_.load(std::memory_order_acquire)) return false;
    slots_[write] = value;
    write_.store(next, std::memory_order_release);
    return true;
  }

  // The consumer's thread only. False: the ring is empty and `value` is as it was.
  bool pop(T& value) noexcept {
    const std::size_t read = read_.load(std::memory_order_relaxed);
    if (read == write_.load(std::memory_order_acquire)) return false;
    value = slots_[read];
    read_.store(after(read), std::memory_order_release);
    return true;
  }

  // Either thread: how many are waiting. The consumer will find as many at least, the producer as many at
  // most.
  std::size_t size() const noexcept {
    const std::size_t read = read_.load(std::memory_order_acquire);
    const std::size_t write = write_.load(std::memory_order_acquire);
    return write >= read ? write - read : write + slots_.size() - read;
  }
  std::size_t capacity() const { return slots_.size() - 1; }

private:
  std::size_t after(std::size_t index) const noexcept { return index + 1 == slots_.size() ? 0 : index + 1; }

  std::vector<T>
      slots_;  // (capacity + 1): the slot before read_ stays empty, so that full differs from empty
  // A cache line each, so that the two threads do not wait for each other's stores.
  alignas(64) std::atomic<std::size_t> write_{0};
  alignas(64) std::atomic<std::size_t> read_{0};
};

}  // namespace fulcrum
