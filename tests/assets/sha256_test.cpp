#include "engine/assets/sha256.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace fulcrum {
namespace {

// FIPS 180-4's examples.
constexpr std::string_view kAbc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
constexpr std::string_view kNothing = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";

TEST(Sha256, KnownAnswers) {
  EXPECT_EQ(sha256_hex({}), kNothing);
  EXPECT_EQ(sha256_hex(std::as_bytes(std::span("abc", 3))), kAbc);
}

TEST(Sha256, PiecesAreTheWholeAndFinishingStartsOver) {
  Sha256 hasher;
  hasher.update("a");
  hasher.update("bc");
  EXPECT_EQ(hasher.finish_hex(), kAbc);
  EXPECT_EQ(hasher.finish_hex(), kNothing);
}

TEST(Sha256, OfAFile) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "fulcrum_sha256_test";
  std::ofstream(path) << "abc";
  const auto hash = sha256_hex(std::move(*RegularFile::open(path)));
  ASSERT_TRUE(hash) << hash.error().sentence;
  EXPECT_EQ(*hash, kAbc);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace fulcrum
