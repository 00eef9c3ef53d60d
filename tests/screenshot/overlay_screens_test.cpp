// Pictures of every screen, for the eye: into the folder FULCRUM_SCREENS, where one is named. Without one a
// few are drawn all the same, and the renderer's validation layers have nothing to say.

#include <cstdlib>
#include <filesystem>
#include <string>

#include "engine/render/picture.h"
#include "layout_screens.h"
#include "overlay_fixture.h"

namespace fulcrum::ui {
namespace {

class OverlayScreensTest : public OverlayTest {};

TEST_F(OverlayScreensTest, AreDrawn) {
  const char* const folder = std::getenv("FULCRUM_SCREENS");  // NOLINT(concurrency-mt-unsafe): no thread runs
  for (const render::Extent size :
       {render::Extent{640, 360}, render::Extent{1280, 720}, render::Extent{1920, 1080}}) {
    if (folder == nullptr && size.height > 360) break;
    renderer_ = std::move(*render::Renderer::create(*gpu_.device, {}, {size, {1, 0, 1.0F}, {}}));
    for (const float text : {1.0F, 1.5F})
      for (const PaletteName palette : {PaletteName::standard, PaletteName::colour_blind})
        for (test::Screen& screen : test::screens()) {
          if (screen.state.target) {
            const glm::vec2 pixels(size.width, size.height);
            screen.state.target->at.place *= pixels;
            *screen.state.target->at.touch *= pixels;
          }
          screen.state.look = {palette, text};
          const render::Picture picture = draw(screen.state);
          EXPECT_EQ(picture.width, size.width);
          if (folder == nullptr) continue;
          const std::string name = screen.name + "-" + std::to_string(size.width) + "-" +
                                   std::to_string(static_cast<int>(100.0F * text)) +
                                   (palette == PaletteName::standard ? "" : "-cb") + ".png";
          EXPECT_FALSE(render::write_png(std::filesystem::path(folder) / name, picture));
        }
  }
}

}  // namespace
}  // namespace fulcrum::ui
