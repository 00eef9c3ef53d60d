// The start page at every size: all of it is in the picture, and what is pressed is what is seen there.

#include <algorithm>
#include <cmath>

#include "engine/ui/start_page.h"
#include "overlay_fixture.h"

namespace fulcrum::ui {
namespace {

using Part = StartPage::Part;

StartPage page_of(std::size_t scenarios) {
  StartPage page;
  for (std::size_t i = 0; i < scenarios; ++i)
    page.scenarios.push_back({"Scenario " + std::to_string(i), i % 2 == 0 ? "best 87" : "", true});
  page.about =
      "A sentence about what is to be done, long enough that it needs more than one line of the sheet.";
  page.facts = "6 checkpoints in 90 s";
  page.settings = {{"Who trains", "P07"}, {"Device", "the mouse"}, {"Hand", "right"}};
  page.help = "Arrows choose, Enter starts, Esc ends";
  return page;
}

// Pixels of the colour that surrounds what is in focus.
int accents(const render::Picture& picture, int x0, int y0, int x1, int y1) {
  int count = 0;
  for (int y = std::max(y0, 0); y < std::min(y1, static_cast<int>(picture.height)); ++y)
    for (int x = std::max(x0, 0); x < std::min(x1, static_cast<int>(picture.width)); ++x) {
      const std::uint8_t* const rgba =
          &picture.rgba[4 * (static_cast<std::size_t>(y) * picture.width + static_cast<std::size_t>(x))];
      if (std::abs(rgba[0] - 84) < 25 && std::abs(rgba[1] - 164) < 25 && std::abs(rgba[2] - 255) < 25)
        ++count;
    }
  return count;
}

struct Box {
  int left = 1 << 20, top = 1 << 20, right = -1, bottom = -1;
};

// Where a press finds that part, in pixels.
Box found(const StartPage& page, render::Extent size, Part part, std::size_t index) {
  Box box;
  for (int y = 0; y < static_cast<int>(size.height); y += 2)
    for (int x = 0; x < static_cast<int>(size.width); x += 2) {
      const auto hit = start_hit(page, size, {}, static_cast<double>(x) / size.height,
                                 static_cast<double>(y) / size.height);
      if (!hit || hit->part != part || (part <= Part::setting && hit->index != index)) continue;
      box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y)};
    }
  return box;
}

class OverlayStartTest : public OverlayTest {
protected:
  render::Picture drawn(const StartPage& page, render::Extent size) {
    renderer_ = std::move(*render::Renderer::create(*gpu_.device, {}, {size, {1, 0, 1.0F}, {}}));
    OverlayState state;
    state.start = page;
    return draw(state);
  }
};

TEST_F(OverlayStartTest, WhatIsInFocusIsSurroundedWhereAPressFindsIt) {
  for (const render::Extent size :
       {render::Extent{640, 360}, render::Extent{1280, 720}, render::Extent{1920, 1080}}) {
    StartPage page = page_of(8);
    const auto expect_surrounded = [&](Part part, std::size_t index) {
      page.focus = part;
      page.index = index;
      if (part == Part::scenario) page.chosen = index;
      const Box box = found(page, size, part, index);
      ASSERT_GT(box.right, box.left) << size.height << ": " << static_cast<int>(part) << " " << index;
      EXPECT_GE(box.right - box.left, 50) << "a button that a finger finds";
      EXPECT_GE(box.bottom - box.top, 18);
      const render::Picture picture = drawn(page, size);
      const int all = accents(picture, 0, 0, static_cast<int>(size.width), static_cast<int>(size.height));
      const int here = accents(picture, box.left - 8, box.top - 8, box.right + 9, box.bottom + 9);
      EXPECT_GT(here, box.right - box.left) << size.height << ": " << static_cast<int>(part) << " " << index;
      EXPECT_EQ(here, all) << "nothing else is surrounded";
    };
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}, std::size_t{7}})
      expect_surrounded(Part::scenario, i);
    for (std::size_t i = 0; i < 3; ++i) expect_surrounded(Part::setting, i);
  }
}

TEST_F(OverlayStartTest, ButtonsAreInThePicture) {
  for (const render::Extent size :
       {render::Extent{640, 360}, render::Extent{1280, 720}, render::Extent{400, 800}}) {
    const StartPage page = page_of(8);
    for (const Part part : {Part::start, Part::settings, Part::end}) {
      const Box box = found(page, size, part, 0);
      EXPECT_GT(box.right, box.left) << size.width << " x " << size.height;
      EXPECT_LT(box.bottom, static_cast<int>(size.height) - 4);
    }
  }
}

// A device that is tested is shown in place of it, at every size: its bars, and the button that closes it.
TEST_F(OverlayStartTest, ADevicesTestIsInThePictureAndCanBeClosed) {
  for (const render::Extent size :
       {render::Extent{640, 360}, render::Extent{1280, 720}, render::Extent{1920, 1080}}) {
    StartPage page = page_of(8);
    page.focus = Part::end;  // surrounded in white, which is no accent
    DevicePanel panel;
    panel.title = "What gamepad senses";
    panel.buttons = "Buttons down: A";
    for (int axis = 0; axis < 6; ++axis) panel.axes.push_back({"toward you", 0, "+0 %", false});
    const auto width = static_cast<int>(size.width), height = static_cast<int>(size.height);
    page.tested = panel;
    const int none = accents(drawn(page, size), 0, 0, width, height);
    panel.axes[0].part = 1;
    page.tested = panel;
    const render::Picture picture = drawn(page, size);
    EXPECT_GT(accents(picture, width / 2, 0, width, height / 2), none + 50) << "a bar to the right";
    panel.axes[0].part = -1;
    page.tested = panel;
    EXPECT_GT(accents(drawn(page, size), 0, 0, width / 2, height / 2), none + 50) << "and to the left";
    int closes = 0;
    for (int y = 0; y < height; y += 2)
      for (int x = 0; x < width; x += 2)
        if (closes_device_panel(panel, size, Look(), static_cast<double>(x) / height,
                                static_cast<double>(y) / height)) {
          ++closes;
          EXPECT_LT(y, height - 4);
        }
    EXPECT_GT(closes, 100) << size.height << ": a button that a finger finds";
  }
}

TEST_F(OverlayStartTest, MoreScenariosThanThereIsRoomForScroll) {
  StartPage page = page_of(60);
  for (const std::size_t chosen : {std::size_t{0}, std::size_t{30}, std::size_t{59}}) {
    page.chosen = page.index = chosen;
    const Box box = found(page, {640, 360}, Part::scenario, chosen);
    EXPECT_GT(box.right, box.left) << chosen;
    EXPECT_LT(box.bottom, 360);
    EXPECT_GT(accents(drawn(page, {640, 360}), box.left - 8, box.top - 8, box.right + 9, box.bottom + 9),
              100);
  }
}

}  // namespace
}  // namespace fulcrum::ui
