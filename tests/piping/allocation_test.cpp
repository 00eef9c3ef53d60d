// No tick allocates: every malloc of the process is counted while ticks run, Eigen's and the C library's too.

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>

#include "haptics/loop/live_loop.h"
#include "tests/piping/piping.h"

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}

namespace {
std::atomic<bool> counting{false};
std::atomic<long> allocations{0};
void count() {
  if (counting.load(std::memory_order_relaxed)) allocations.fetch_add(1, std::memory_order_relaxed);
}
}  // namespace

extern "C" {
void* malloc(std::size_t size) {
  count();
  return __libc_malloc(size);
}
void* calloc(std::size_t n, std::size_t size) {
  count();
  return __libc_calloc(n, size);
}
void* realloc(void* memory, std::size_t size) {
  count();
  return __libc_realloc(memory, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  count();
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  count();
  *memory = __libc_memalign(alignment, size);
  return 0;
}
}

namespace fulcrum::test {
namespace {

long allocations_in(const std::string& hand, int ticks) {
  PipingRun run(hand);
  allocations = 0;
  counting = true;
  for (int i = 0; i < ticks; ++i) run.tick();
  counting = false;
  return allocations;
}

TEST(Allocation, TheCounterCounts) {
  allocations = 0;
  counting = true;
  std::vector<int>* made = new std::vector<int>(100);
  counting = false;
  delete made;
  EXPECT_EQ(allocations, 2);
}

TEST(Allocation, NoTickOfAnyHandAllocates) {
  EXPECT_EQ(allocations_in("expert", 10000), 0);
  EXPECT_EQ(allocations_in("clumsy", 10000), 0);
  EXPECT_EQ(allocations_in("still", 1000), 0);
}

}  // namespace
}  // namespace fulcrum::test
