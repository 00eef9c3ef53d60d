#include "engine/assets/bake_cache.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/haptics/bake/shapes.h"

namespace fulcrum {
namespace {

namespace fs = std::filesystem;

class BakeCacheTest : public testing::Test {
protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    const auto solid = build_solid(shapes::torus(0.03, 0.01, 40, 16));
    ASSERT_TRUE(solid);
    solid_ = *solid;
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder_)) found.push_back(entry.path());
    return found;
  }

  fs::path folder_ = fs::path(testing::TempDir()) / "fulcrum_bake_cache_test" /
                     testing::UnitTest::GetInstance()->current_test_info()->name();
  BakeCache cache_{folder_};
  Solid solid_;
  FieldDesc field_desc_{2e-3, 4e-3};
  PointshellDesc shell_desc_{3e-3};
};

TEST_F(BakeCacheTest, TheSecondTimeItIsReadBackTheSame) {
  const auto made = cache_.field(solid_, field_desc_);
  ASSERT_TRUE(made);
  EXPECT_FALSE(made->from_cache);
  EXPECT_EQ(made->note, "");
  FieldDesc more_threads = field_desc_;
  more_threads.threads = 3;  // changes nothing, so it names the same bake
  const auto read = cache_.field(solid_, more_threads);
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->from_cache);
  EXPECT_EQ(read->value.data().values_int16, made->value.data().values_int16);
  EXPECT_EQ(read->value.data().centre_m, made->value.data().centre_m);
  EXPECT_EQ(read->value.error_bound_m(), made->value.error_bound_m());
  EXPECT_EQ(read->value.thinnest_feature_m(), made->value.thinnest_feature_m());
  EXPECT_EQ(read->value.distance(Vec3(0.03, 0.012, 0)), made->value.distance(Vec3(0.03, 0.012, 0)));

  const auto shell = cache_.pointshell(solid_, shell_desc_);
  const auto shell_again = cache_.pointshell(solid_, shell_desc_);
  ASSERT_TRUE(shell && shell_again);
  EXPECT_FALSE(shell->from_cache);
  EXPECT_TRUE(shell_again->from_cache);
  EXPECT_EQ(shell->value.positions, shell_again->value.positions);
  EXPECT_EQ(shell->value.normals, shell_again->value.normals);
  EXPECT_EQ(shell->value.areas_m2, shell_again->value.areas_m2);
  EXPECT_EQ(shell->value.covering_radius_m, shell_again->value.covering_radius_m);
}

TEST_F(BakeCacheTest, OtherParametersAndOtherMeshesAreOtherBakes) {
  ASSERT_TRUE(cache_.field(solid_, field_desc_));
  EXPECT_FALSE(cache_.field(solid_, {2.5e-3, 5e-3})->from_cache);
  Solid moved = solid_;
  moved.mesh.vertices[7].x() += 1e-7;
  EXPECT_FALSE(cache_.field(moved, field_desc_)->from_cache);
  EXPECT_EQ(files().size(), 3u);
}

TEST_F(BakeCacheTest, DamageIsNoticedAndRepaired) {
  const auto made = cache_.field(solid_, field_desc_);
  ASSERT_TRUE(made);
  ASSERT_EQ(files().size(), 1u);
  const fs::path file = files()[0];
  const auto size = fs::file_size(file);

  const auto expect_repaired = [&](const char* damage) {
    const auto repaired = cache_.field(solid_, field_desc_);
    ASSERT_TRUE(repaired) << damage;
    EXPECT_FALSE(repaired->from_cache) << damage;
    EXPECT_NE(repaired->note.find("was damaged and has been made anew"), std::string::npos) << damage;
    EXPECT_EQ(repaired->value.data().values_int16, made->value.data().values_int16) << damage;
    EXPECT_TRUE(cache_.field(solid_, field_desc_)->from_cache) << damage;
  };
  for (const std::uintmax_t place :
       {std::uintmax_t{0}, std::uintmax_t{64}, std::uintmax_t{200}, size / 2, size - 1}) {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekg(static_cast<std::streamoff>(place));
    const char byte = static_cast<char>(stream.get() ^ 1);
    stream.seekp(static_cast<std::streamoff>(place));
    stream.put(byte);
    stream.close();
    expect_repaired("a flipped bit");
  }
  for (const std::uintmax_t shorter : {std::uintmax_t{0}, std::uintmax_t{63}, std::uintmax_t{64}, size - 1}) {
    fs::resize_file(file, shorter);
    expect_repaired("a missing end");
  }
  fs::resize_file(file, size + 4);
  expect_repaired("something appended");
}

// A pipe would be waited for; what a bake of another time was killed in goes.
TEST_F(BakeCacheTest, WhatIsNoBakeIsReplaced) {
  ASSERT_TRUE(cache_.field(solid_, field_desc_));
  const fs::path file = files().at(0);
  fs::remove(file);
  ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
  std::ofstream(file.string() + ".123.part") << "half";
  const auto made = cache_.field(solid_, field_desc_);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->note, "");
  EXPECT_TRUE(cache_.field(solid_, field_desc_)->from_cache);
  EXPECT_EQ(files(), std::vector{file});
}

TEST_F(BakeCacheTest, AFolderThatCannotBeWrittenIsNoError) {
  std::ofstream(folder_ / "a_file") << "not a folder";
  const BakeCache cache(folder_ / "a_file" / "below");
  const auto made = cache.field(solid_, field_desc_);
  ASSERT_TRUE(made);
  EXPECT_FALSE(made->from_cache);
  EXPECT_NE(made->note.find("could not be kept"), std::string::npos) << made->note;
}

TEST_F(BakeCacheTest, TheBakesOwnErrorComesThrough) {
  const auto refused = cache_.field(solid_, {0.0, 1e-3});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence.find("voxel must be a positive length"), std::string::npos);
}

TEST_F(BakeCacheTest, TheFolderFollowsTheEnvironment) {
  const std::string before = std::getenv("XDG_CACHE_HOME") != nullptr ? std::getenv("XDG_CACHE_HOME") : "";
  ::setenv("XDG_CACHE_HOME", "/somewhere", 1);
  EXPECT_EQ(BakeCache().folder(), fs::path("/somewhere/fulcrum"));
  ::setenv("XDG_CACHE_HOME", "relative", 1);
  EXPECT_NE(BakeCache().folder(), fs::path("relative/fulcrum"));
  if (before.empty())
    ::unsetenv("XDG_CACHE_HOME");
  else
    ::setenv("XDG_CACHE_HOME", before.c_str(), 1);
}

}  // namespace
}  // namespace fulcrum
