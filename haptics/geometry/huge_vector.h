#pragma once
// An array that ticks read all over, on pages of 2 MiB where the system grants them: with pages of 4 KiB the
// processor's table of pages (TLB) reaches only a few MiB of a field of 100, and most look-ups miss it.

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace fulcrum {

template <class T>
class HugePages {
public:
  using value_type = T;

  HugePages() = default;
  template <class U>
  HugePages(const HugePages<U>&) noexcept {}

  T* allocate(std::size_t count) {
    if (count > kMostBytes / sizeof(T)) throw std::bad_array_new_length();
    const std::size_t bytes = count * sizeof(T);
    if (bytes < kPage) return static_cast<T*>(::operator new(bytes));
    const std::size_t whole = (bytes + kPage - 1) / kPage * kPage;
    void* const at = std::aligned_alloc(kPage, whole);
    if (at == nullptr) throw std::bad_alloc();
    ::madvise(at, whole, MADV_HUGEPAGE);  // a wish: without it the array is as good, and slower
    return static_cast<T*>(at);
  }
  void deallocate(T* at, std::size_t count) noexcept {
    if (count * sizeof(T) < kPage)
      ::operator delete(at);
    else
      std::free(at);
  }

  bool operator==(const HugePages&) const = default;

private:
  static constexpr std::size_t kPage = std::size_t{2} << 20;  // bytes
  static constexpr std::size_t kMostBytes = std::size_t{1} << 62;
};

template <class T>
using HugeVector = std::vector<T, HugePages<T>>;

}  // namespace fulcrum
