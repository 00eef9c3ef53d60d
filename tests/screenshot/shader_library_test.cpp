// Shaders that are worked on: compiled while running, and kept when they break.

#include "engine/render/shader_library.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>

#include "test_scene.h"

namespace fulcrum::render {
namespace {
namespace fs = std::filesystem;

class ShaderFolder : public testing::Test {
protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::copy(FULCRUM_TEST_SHADERS, folder_, fs::copy_options::recursive);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    // Later than what the library has seen, whatever the resolution of the file system's clock.
    fs::last_write_time(folder_ / name, fs::file_time_type::clock::now() + std::chrono::seconds(++writes_));
  }

  fs::path folder_ =
      fs::path(testing::TempDir()) /
      (std::string("fulcrum_") + testing::UnitTest::GetInstance()->current_test_info()->name());
  int writes_ = 0;
};

const char* const kRed = R"(#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;
void main() { colour = vec4(0.5 + 0.01 * uv.x, 0.0, 0.0, 1.0); }
)";

TEST(ShaderLibrary, HasEveryShaderBuiltIn) {
  const ShaderLibrary library = std::move(*ShaderLibrary::open({}));
  EXPECT_FALSE(library.code("tone.frag").empty());
  EXPECT_THROW(library.code("no.frag"), vulkan::Failure);
}

TEST(ShaderLibrary, SaysThatAFolderIsMissing) {
  EXPECT_NE(ShaderLibrary::open("/nonexistent").error().sentence.find("/nonexistent"), std::string::npos);
}

TEST_F(ShaderFolder, IsCompiledAgainWhenItChanges) {
  ShaderLibrary library = std::move(*ShaderLibrary::open(folder_));
  EXPECT_FALSE(*library.refresh());
  write("background.frag", kRed);
  EXPECT_TRUE(*library.refresh());
  EXPECT_FALSE(*library.refresh());
}

TEST_F(ShaderFolder, AnIncludedFileCounts) {
  ShaderLibrary library = std::move(*ShaderLibrary::open(folder_));
  write("include/range.glsl", "this is no GLSL");
  const auto broken = library.refresh();
  ASSERT_FALSE(broken);
  EXPECT_NE(broken.error().sentence.find("range.glsl"), std::string::npos);
}

TEST_F(ShaderFolder, ABrokenShaderIsReportedOnceAndTheOldOneKept) {
  ShaderLibrary library = std::move(*ShaderLibrary::open(folder_));
  const std::size_t size = library.code("background.frag").size();
  write("background.frag", "#version 460\nvoid main() { colour = 1; }\n");
  const auto broken = library.refresh();
  ASSERT_FALSE(broken);
  EXPECT_NE(broken.error().sentence.find("background.frag"), std::string::npos);
  EXPECT_FALSE(*library.refresh());
  EXPECT_EQ(library.code("background.frag").size(), size);
}

TEST_F(ShaderFolder, ARendererDrawsWithTheNewShaderAndSurvivesABrokenOne) {
  const test::Gpu gpu = test::make_gpu();
  const VisualDesc empty;
  RenderOptions options{{64, 64}, {1, 0, 1.0F}, folder_};
  const auto renderer = std::move(*Renderer::create(*gpu.device, empty, options));
  const auto picture = [&] {
    EXPECT_FALSE(renderer->frame({}));
    return *renderer->read_back();
  };
  const Picture grey = picture();
  write("background.frag", kRed);
  const glm::vec3 red = test::mean(picture(), 0.0F, 0.0F, 1.0F, 1.0F);
  EXPECT_GT(red.r, 2.0F * red.g);
  write("background.frag", "broken");
  testing::internal::CaptureStderr();
  const glm::vec3 still_red = test::mean(picture(), 0.0F, 0.0F, 1.0F, 1.0F);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("background.frag"), std::string::npos);
  EXPECT_EQ(red, still_red);
  EXPECT_TRUE(gpu.instance.messages().empty());
}

}  // namespace
}  // namespace fulcrum::render
