// No tick allocates: every malloc of the process is counted while ticks run, Eigen's and the C library's too.
// Nor does it ask the system for anything but the time, which the kernel says of the thread that runs them.

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <set>
#include <thread>

#include "engine/app/prepare/prepare.h"
#include "engine/scenario/content.h"
#include "haptics/loop/run_tick.h"
#include "tests/support/system_calls.h"

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

constexpr int kTicks = 10000;

long allocations_in(const app::Prepared& prepared, const std::string& hand) {
  World world = std::move(*World::build(prepared.haptic.scene));
  const std::unique_ptr<SimulatedDevice> device = std::move(*app::simulated_device(prepared, hand));
  SystemCalls calls;
  bool watched = false;
  std::set<int> seen;
  std::thread([&] {
    watched = calls.watch();
    TickEvent event;
    allocations = 0;
    counting = true;
    for (int i = 0; i < kTicks; ++i) run_tick(world, *device, {}, event);
    counting = false;
    seen = calls.seen();
  }).join();
  if (watched)
    EXPECT_TRUE(seen.empty()) << prepared.name << " in hand " << hand << " makes call number "
                              << *seen.begin();
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

TEST(Allocation, NoTickOfAnyShippedScenarioInAnyHandAllocates) {
  int runs = 0;
  for (const scenario::ScenarioListing& listing : scenario::list_scenarios()) {
    const std::optional<app::Prepared> prepared = app::prepare(listing.name, std::vector<std::string>());
    ASSERT_TRUE(prepared) << listing.name;
    for (const scenario::HandScript& hand : prepared->haptic.hands) {
      EXPECT_EQ(allocations_in(*prepared, hand.name), 0) << listing.name << " in hand " << hand.name;
      ++runs;
    }
  }
  EXPECT_GE(runs, 5);
}

// Of the shipped hands, the clumsy one in the piping strikes most often.
TEST(Allocation, NoTickWithImpactsAllocates) {
  const std::optional<app::Prepared> prepared =
      app::prepare("piping", std::vector<std::string>{"impact_vibration={voices: 4, distance: beam}"});
  ASSERT_TRUE(prepared);
  EXPECT_EQ(allocations_in(*prepared, "clumsy"), 0);
}

TEST(Allocation, NoTickOnTrianglesAllocates) {
  for (const std::string hand : {"expert", "clumsy"}) {
    const std::optional<app::Prepared> prepared =
        app::prepare("tutorial", std::vector<std::string>{"contact.surface=triangles"});
    ASSERT_TRUE(prepared);
    ASSERT_TRUE(prepared->haptic.scene.tool_features);
    EXPECT_EQ(allocations_in(*prepared, hand), 0) << hand;
  }
}

TEST(Allocation, NoTickThatVibratesAtTheFingerAllocates) {
  for (const std::string model : {"two_channel", "rumble_pad"}) {
    const std::optional<app::Prepared> prepared =
        app::prepare("piping", std::vector{"device.model=" + model});
    ASSERT_TRUE(prepared);
    EXPECT_EQ(allocations_in(*prepared, "clumsy"), 0) << model;
  }
}

// With a band that the tremor leaves, so that it pulls as well.
TEST(Allocation, NoTickWithGuidanceAllocates) {
  for (const std::string hand : {"expert", "clumsy"}) {
    const std::optional<app::Prepared> prepared =
        app::prepare("piping", std::vector<std::string>{"guidance={dead_band: 0.0001, gain: 1}"});
    ASSERT_TRUE(prepared);
    EXPECT_EQ(allocations_in(*prepared, hand), 0) << hand;
  }
}

TEST(Allocation, NoTickInWallsOrAdriftAllocates) {
  const std::optional<app::Prepared> prepared = app::prepare(
      "piping", std::vector<std::string>{"device.workspace_walls={margin: 0.03}", "device.drift=0.05"});
  ASSERT_TRUE(prepared);
  EXPECT_EQ(allocations_in(*prepared, "expert"), 0);
}

// Direct rendering, a strip, a filter, a hand that holds the stylus elsewhere than at the handle.
TEST(Allocation, NoTickWithAHoldingPointAllocates) {
  std::optional<app::Prepared> prepared = app::prepare(
      "plate", std::vector<std::string>{"contact={response: direct, stiffness: 300, levels: [300, 600]}",
                                        "holding_point={place: 0.05, low: -0.1, high: 0.1}",
                                        "inertia_compensation={filter: {kind: adaptive}}"});
  ASSERT_TRUE(prepared);
  prepared->haptic.scene.device.strip = HoldingStripDesc{};
  for (scenario::HandScript& hand : prepared->haptic.hands) hand.waypoints.front().hold = 0.05;
  EXPECT_EQ(allocations_in(*prepared, "expert"), 0);
}

}  // namespace
}  // namespace fulcrum::test
