// Levels of detail from the cache: the same as made anew, and made anew where the cache is no good.

#include "engine/scenario/kept_levels.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace fulcrum::scenario {
namespace {

namespace fs = std::filesystem;

// A square of 2 x 64 x 64 triangles, 0.1 m wide.
render::Mesh fine_square() {
  constexpr std::uint32_t kSide = 65;
  render::Mesh mesh;
  for (std::uint32_t i = 0; i < kSide; ++i)
    for (std::uint32_t j = 0; j < kSide; ++j) {
      mesh.positions.push_back(0.1F / (kSide - 1) * glm::vec3(i, 0.0F, j));
      mesh.normals.push_back({0.0F, 1.0F, 0.0F});
    }
  for (std::uint32_t i = 0; i + 1 < kSide; ++i)
    for (std::uint32_t j = 0; j + 1 < kSide; ++j) {
      const std::uint32_t at = i * kSide + j;
      for (const std::uint32_t v : {at, at + 1, at + kSide, at + 1, at + kSide + 1, at + kSide})
        mesh.indices.push_back(v);
    }
  return mesh;
}

class KeptLevels : public testing::Test {
protected:
  KeptLevels() { fs::remove_all(folder_); }
  ~KeptLevels() override { fs::remove_all(folder_); }

  std::optional<render::LevelsOfDetail> levels(const render::Mesh& mesh) {
    render::VisualDesc desc;
    desc.meshes.push_back(mesh);
    notes_ = add_levels_of_detail(desc, BakeCache(folder_));
    return desc.meshes.front().levels;
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  // Of each test its own: several run at once.
  fs::path folder_ =
      fs::path(testing::TempDir()) /
      (std::string("fulcrum_kept_levels_") + testing::UnitTest::GetInstance()->current_test_info()->name());
  std::vector<std::string> notes_;
};

void expect_same(const render::LevelsOfDetail& a, const render::LevelsOfDetail& b) {
  EXPECT_EQ(a.indices, b.indices);
  ASSERT_EQ(a.pieces.size(), b.pieces.size());
  for (std::size_t i = 0; i < a.pieces.size(); ++i) {
    EXPECT_EQ(a.pieces[i].bounds.low, b.pieces[i].bounds.low);
    EXPECT_EQ(a.pieces[i].bounds.high, b.pieces[i].bounds.high);
    ASSERT_EQ(a.pieces[i].levels.size(), b.pieces[i].levels.size());
    for (std::size_t k = 0; k < a.pieces[i].levels.size(); ++k)
      EXPECT_EQ(a.pieces[i].levels[k].error, b.pieces[i].levels[k].error);
  }
}

TEST_F(KeptLevels, AreTheSameFromTheCache) {
  const render::Mesh mesh = fine_square();
  const auto made = levels(mesh);
  ASSERT_TRUE(made);
  EXPECT_EQ(files(), 1U);
  const auto kept = levels(mesh);
  EXPECT_TRUE(notes_.empty());
  expect_same(*made, *kept);
  expect_same(*made, render::levels_of_detail(mesh));
}

TEST_F(KeptLevels, OfAnotherMeshAreOthers) {
  render::Mesh mesh = fine_square();
  levels(mesh);
  mesh.colours.assign(mesh.positions.size(), glm::vec3(0.5F));
  levels(mesh);
  EXPECT_EQ(files(), 2U);
}

// Of the same surface with nothing laid on there are others, which are kept as they were before.
TEST_F(KeptLevels, OfATexturedMeshAreOthers) {
  render::VisualDesc desc;
  desc.meshes.push_back(fine_square());
  for (const glm::vec3& p : desc.meshes.front().positions)
    desc.meshes.front().uv.emplace_back(300.0F * (p.x * p.x + p.z * p.z), 10.0F * p.z, 0.0F, 0.0F);
  desc.materials.push_back({});
  desc.instances.push_back({});
  const auto made = [&] {
    desc.meshes.front().levels.reset();
    EXPECT_TRUE(add_levels_of_detail(desc, BakeCache(folder_)).empty());
    return desc.meshes.front().levels.value();
  };
  const render::LevelsOfDetail bare = made();
  expect_same(bare, *levels(fine_square()));
  EXPECT_EQ(files(), 1U);
  auto& layers = desc.materials.front().detail.emplace().layers;
  layers[render::SurfaceDetail::base_colour] = render::TextureLayer{};
  for (int time = 0; time < 2; ++time) {  // made, and from the cache
    const render::LevelsOfDetail textured = made();
    EXPECT_GT(textured.pieces.front().levels.back().error,
              10.0F * bare.pieces.front().levels.back().error + 1e-4F);
    expect_same(textured, render::levels_of_detail(desc.meshes.front(), {true, false}));
    EXPECT_EQ(files(), 2U);
  }
  layers[render::SurfaceDetail::base_colour]->uv_set = 1;  // where all of it lies at one place
  expect_same(made(), bare);
  EXPECT_EQ(files(), 3U);
}

TEST_F(KeptLevels, SmallMeshesShareAFile) {
  render::Mesh mesh = fine_square();
  mesh.indices.resize(3 * 1000);
  render::VisualDesc desc;
  for (int i = 0; i < 3; ++i) {
    desc.meshes.push_back(mesh);
    mesh.positions.front().y += 0.001F;
  }
  desc.meshes.push_back(fine_square());
  for (int time = 0; time < 2; ++time) {  // made, and from the cache
    EXPECT_TRUE(add_levels_of_detail(desc, BakeCache(folder_)).empty());
    EXPECT_EQ(files(), 2U);
    for (render::Mesh& each : desc.meshes) {
      ASSERT_TRUE(each.levels);
      expect_same(*each.levels, render::levels_of_detail(each));
      each.levels.reset();
    }
  }
}

TEST_F(KeptLevels, ADamagedFileIsMadeAnewAndNoted) {
  const render::Mesh mesh = fine_square();
  const auto made = levels(mesh);
  const fs::path file = fs::directory_iterator(folder_)->path();
  fs::resize_file(file, fs::file_size(file) - 4);
  const auto again = levels(mesh);
  ASSERT_EQ(notes_.size(), 1U);
  EXPECT_NE(notes_.front().find("was damaged"), std::string::npos) << notes_.front();
  expect_same(*made, *again);
  levels(mesh);
  EXPECT_TRUE(notes_.empty());
}

TEST_F(KeptLevels, ASmallMeshHasNone) {
  render::Mesh mesh = fine_square();
  mesh.indices.resize(3 * (render::kTrianglesWorthLevels - 1));
  EXPECT_FALSE(levels(mesh));
  EXPECT_FALSE(fs::exists(folder_) && files() > 0);
}

}  // namespace
}  // namespace fulcrum::scenario
