// Which device is chosen, how its absence reads, and how its memory is handed out.

#include "engine/vulkan/device.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "engine/vulkan/buffer.h"
#include "test_scene.h"

namespace fulcrum::vulkan {
namespace {

const std::vector<DeviceInfo> kDevices = {{0, "llvmpipe (LLVM 15.0.6, 256 bits)", "software", ""},
                                          {1, "Radeon RX 6400", "graphics card", ""},
                                          {2, "Old Card", "graphics card", "its driver offers Vulkan 1.1"}};

TEST(Device, PrefersAGraphicsCard) {
  EXPECT_EQ(choose(kDevices, "")->index, 1U);
}

TEST(Device, IsFoundByNumberAndByPartOfItsName) {
  EXPECT_EQ(choose(kDevices, "0")->index, 0U);
  EXPECT_EQ(choose(kDevices, "LLVM")->index, 0U);
  EXPECT_EQ(choose(kDevices, "radeon")->index, 1U);
}

TEST(Device, AnUnknownOneIsAnsweredWithTheList) {
  const std::string sentence = choose(kDevices, "GeForce").error().sentence;
  EXPECT_NE(sentence.find("\"GeForce\""), std::string::npos);
  EXPECT_NE(sentence.find("1  Radeon RX 6400 (graphics card)"), std::string::npos);
}

TEST(Device, AnUnusableOneIsAnsweredWithTheReason) {
  EXPECT_NE(choose(kDevices, "2").error().sentence.find("Vulkan 1.1"), std::string::npos);
}

TEST(Device, WithoutAnyDriverTheSentenceNamesAPackage) {
  setenv("VK_ICD_FILENAMES", "/nonexistent.json", 1);
  setenv("VK_DRIVER_FILES", "/nonexistent.json", 1);
  const Result<Instance> instance = Instance::create({});
  std::string sentence = instance ? "" : instance.error().sentence;
  if (instance) {
    const auto device = Device::create(*instance, "");
    sentence = device ? "" : device.error().sentence;
  }
  unsetenv("VK_ICD_FILENAMES");
  unsetenv("VK_DRIVER_FILES");
  EXPECT_NE(sentence.find("mesa-vulkan-drivers"), std::string::npos) << sentence;
}

TEST(Device, MemoryComesBackAndIsUsedAgain) {
  const test::Gpu gpu = test::make_gpu();
  std::vector<Buffer> buffers;
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 200; ++i) {  // 200 x 1 MiB: several blocks
      buffers.emplace_back(*gpu.device, VkDeviceSize{1} << 20, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                           Place::upload);
      *buffers.back().mapped() = std::byte{1};
    }
    buffers.clear();
  }
  buffers.emplace_back(*gpu.device, VkDeviceSize{64} << 20, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                       Place::device);
  EXPECT_EQ(buffers.back().mapped(), nullptr);
  EXPECT_TRUE(gpu.instance.messages().empty());
}

TEST(FreeList, GivesAlignedPlacesThatNeverOverlap) {
  FreeList list(1 << 16);
  std::mt19937 random(7);
  struct Piece {
    std::uint64_t offset, size;
  };
  std::vector<Piece> held;
  for (int i = 0; i < 5000; ++i) {
    const std::uint64_t size = 1 + random() % 3000;
    const std::uint64_t alignment = std::uint64_t{1} << (random() % 9);
    if (const auto offset = list.take(size, alignment); offset && random() % 3 != 0) {
      EXPECT_EQ(*offset % alignment, 0U);
      EXPECT_LE(*offset + size, std::uint64_t{1} << 16);
      for (const Piece& other : held)
        EXPECT_TRUE(*offset + size <= other.offset || other.offset + other.size <= *offset);
      held.push_back({*offset, size});
    } else if (offset) {
      list.give_back(*offset, size);
    }
    if (!held.empty() && random() % 2 == 0) {
      std::swap(held[random() % held.size()], held.back());
      list.give_back(held.back().offset, held.back().size);
      held.pop_back();
    }
  }
  for (const Piece& piece : held) list.give_back(piece.offset, piece.size);
  EXPECT_EQ(list.take(1 << 16, 1), 0U);  // joined to one again
}

}  // namespace
}  // namespace fulcrum::vulkan
