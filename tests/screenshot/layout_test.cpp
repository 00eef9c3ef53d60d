// Every screen at the sizes that people use, in both palettes and at every size of text: all words stand on a
// card and in the picture, no card and no word lies over another, and nothing is cut off. Laid out without a
// device: what is drawn is noted (LayoutLog) in place of looked for in a picture.

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "engine/ui/cue_panel.h"
#include "engine/ui/fonts.h"
#include "engine/ui/panels.h"
#include "layout_screens.h"

namespace fulcrum::ui {
namespace {

constexpr float kSlack = 1.0F;  // theme units: glyphs stand on whole pixels

struct Size {
  std::uint32_t width, height;
};

std::string text_of(const Area& area) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.0f, %.0f) %.0f x %.0f", static_cast<double>(area.at.x),
                static_cast<double>(area.at.y), static_cast<double>(area.size.x),
                static_cast<double>(area.size.y));
  return text;
}

bool inside(const Area& inner, const Area& outer) {
  return inner.at.x >= outer.at.x - kSlack && inner.at.y >= outer.at.y - kSlack &&
         inner.at.x + inner.size.x <= outer.at.x + outer.size.x + kSlack &&
         inner.at.y + inner.size.y <= outer.at.y + outer.size.y + kSlack;
}

bool overlap(const Area& a, const Area& b) {
  return a.at.x + kSlack < b.at.x + b.size.x && b.at.x + kSlack < a.at.x + a.size.x &&
         a.at.y + kSlack < b.at.y + b.size.y && b.at.y + kSlack < a.at.y + a.size.y;
}

// The letters, without the room above and below them that their line has.
Area ink(const Area& words) {
  return {{words.at.x, words.at.y + 0.18F * words.size.y}, {words.size.x, 0.64F * words.size.y}};
}

class LayoutTest : public testing::Test {
protected:
  void SetUp() override {
    context_ = ImGui::CreateContext();
    ImGui::SetCurrentContext(context_);
    ImGui::GetIO().IniFilename = nullptr;
  }
  void TearDown() override { ImGui::DestroyContext(context_); }

  struct LaidOut {
    LayoutLog log;
    Area picture;
    std::size_t pages = 0;  // of the keys
  };

  LaidOut lay_out(OverlayState state, const Size& size, const Look& look) {
    const float scale = overlay_scale(size.height, look.text);
    if (!fonts_.contains(scale)) {
      fonts_.clear();  // an atlas is of one scale
      std::string note;
      fonts_[scale] = load_fonts(scale, note);
      EXPECT_EQ(note, "") << "widths are those of the typeface that is installed with Fulcrum";
      unsigned char* pixels = nullptr;
      int width = 0, height = 0;
      ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    }
    const ImVec2 pixels{static_cast<float>(size.width), static_cast<float>(size.height)};
    if (state.target) {
      state.target->at.place *= glm::vec2(pixels.x, pixels.y);
      *state.target->at.touch *= glm::vec2(pixels.x, pixels.y);
    }
    state.look = look;
    ImGui::GetIO().DisplaySize = pixels;
    ImGui::GetIO().DeltaTime = 1.0F / 60.0F;
    ImGui::NewFrame();
    LaidOut out;
    const Canvas canvas(*ImGui::GetBackgroundDrawList(), fonts_[scale], palette(look.palette), pixels, scale,
                        &out.log);
    out.picture = {{0.0F, 0.0F}, {canvas.width(), canvas.height()}};
    draw_overlay(canvas, state, {state.force_N.value, state.torque_Nm.value});
    out.pages = keys_pages(canvas, state);
    ImGui::EndFrame();
    return out;
  }

  // What is wrong with it, a line each; empty: nothing.
  static std::string faults_of(const LaidOut& out) {
    std::string faults;
    const LayoutLog& log = out.log;
    for (std::size_t i = 0; i < log.cards.size(); ++i) {
      const Area& card = log.cards[i];
      const bool across = card.size.x >= out.picture.size.x;  // a band reaches beyond both sides
      if (!across && !inside(card, out.picture)) faults += "card " + text_of(card) + " leaves the picture\n";
      for (std::size_t j = i + 1; j < log.cards.size(); ++j)
        if (overlap(card, log.cards[j]))
          faults += "card " + text_of(card) + " and card " + text_of(log.cards[j]) + "\n";
    }
    for (std::size_t i = 0; i < log.words.size(); ++i) {
      const LayoutLog::Words& words = log.words[i];
      if (!inside(ink(words.area), out.picture))
        faults += "'" + words.words + "' " + text_of(words.area) + " leaves the picture\n";
      const bool on_card = words.card > 0 && inside(ink(words.area), log.cards[words.card - 1]);
      const bool on_any =
          std::ranges::any_of(log.cards, [&](const Area& card) { return inside(ink(words.area), card); });
      if (!on_card && !on_any)
        faults += "'" + words.words + "' " + text_of(words.area) + " leaves its card\n";
      for (std::size_t j = i + 1; j < log.words.size(); ++j)
        if (overlap(ink(words.area), ink(log.words[j].area)))
          faults += "'" + words.words + "' and '" + log.words[j].words + "'\n";
    }
    for (const std::string& words : std::set(log.cut.begin(), log.cut.end()))
      faults += "'" + words + "' is cut off\n";
    return faults;
  }

private:
  ImGuiContext* context_ = nullptr;
  std::map<float, Fonts> fonts_;
};

constexpr Size kSizes[] = {{640, 360}, {1280, 720}, {1920, 1080}};
constexpr Size kLessBars[] = {{640, 335}, {1280, 693}, {1920, 1040}};  // of a title, and of a desktop
constexpr float kTexts[] = {1.0F, 1.25F, 1.5F};

TEST_F(LayoutTest, NothingIsCutOffOrCovered) {
  std::vector<Size> sizes(std::begin(kSizes), std::end(kSizes));
  sizes.insert(sizes.end(), std::begin(kLessBars), std::end(kLessBars));
  for (const Size& size : sizes)
    for (const float text : kTexts)
      for (const test::Screen& screen : test::screens())
        for (const PaletteName palette : {PaletteName::standard, PaletteName::colour_blind}) {
          const LaidOut out = lay_out(screen.state, size, {palette, text});
          EXPECT_EQ(faults_of(out), "")
              << screen.name << ", " << size.width << " x " << size.height << ", text " << text;
          EXPECT_FALSE(out.log.words.empty()) << screen.name;
        }
}

// What has to be there whatever the size: what a stop says, all keys (over the pages), the rows of the
// settings, the buttons of the start page, and what came of the trial.
TEST_F(LayoutTest, WhatCountsIsThere) {
  for (const Size& size : kSizes)
    for (const float text : kTexts)
      for (const test::Screen& screen : test::screens()) {
        std::set<std::string> said;
        OverlayState state = screen.state;
        const std::size_t pages = lay_out(state, size, {PaletteName::standard, text}).pages;
        for (state.keys_page = 0; state.keys_page == 0 || state.keys_page < pages; ++state.keys_page) {
          const LaidOut out = lay_out(state, size, {PaletteName::standard, text});
          EXPECT_EQ(faults_of(out), "") << screen.name << ", page " << state.keys_page;
          for (const LayoutLog::Words& words : out.log.words) said.insert(words.words);
        }
        const auto expect = [&](const std::string& words) {
          EXPECT_TRUE(said.contains(words)) << screen.name << ", " << size.width << " x " << size.height
                                            << ", text " << text << ": '" << words << "' is not there";
        };
        if (state.keys_visible)
          for (const KeyLine& line : state.keys) expect(line.key);
        if (state.settings)
          for (const StartPage::Setting& row : state.settings->rows) expect(row.value);
        if (state.start && state.start->tested) {
          expect("Close");
          for (const DevicePanel::Axis& axis : state.start->tested->axes) expect(axis.name);
        } else if (state.start) {
          for (const char* button : {"Start", "Settings", "End"}) expect(button);
          for (const StartPage::Setting& row : state.start->settings) expect(row.value);
        }
        if (state.force == Force::stopped && !state.keys_visible) expect("Press Enter to resume");
        if (state.debrief && !state.keys_visible) {
          for (const Debrief::Row& row : state.debrief->rows) {
            expect(row.value);
            if (row.points) expect(*row.points);
          }
        }
        const bool plain = !state.start && !state.settings && !state.busy && !state.keys_visible &&
                           !state.debrief && state.force == Force::on;
        if (plain) expect(state.scenario);
        if (plain && !state.timeline) expect(state.device);
      }
}

// Panels are left out where there is no room, and none lies over another or beyond the picture.
TEST_F(LayoutTest, SmallWindowsLeavePanelsOutInPlaceOfCoveringThem) {
  for (const Size& size :
       {Size{320, 180}, {400, 800}, {480, 270}, {500, 200}, {250, 500}, {64, 64}, {16, 16}})
    for (const float text : kTexts)
      for (const test::Screen& screen : test::screens()) {
        const LaidOut out = lay_out(screen.state, size, {PaletteName::standard, text});
        std::string covered;
        for (std::size_t i = 0; i < out.log.cards.size(); ++i)
          for (std::size_t j = i + 1; j < out.log.cards.size(); ++j)
            if (overlap(out.log.cards[i], out.log.cards[j]))
              covered += text_of(out.log.cards[i]) + " and " + text_of(out.log.cards[j]) + "\n";
        EXPECT_EQ(covered, "") << screen.name << ", " << size.width << " x " << size.height << ", text "
                               << text;
      }
  // There is still something of a trial in a window of a quarter of the smallest that people use.
  const OverlayState piping = test::screen("piping");
  EXPECT_GE(lay_out(piping, {320, 180}, {}).log.cards.size(), 2U);
  EXPECT_GE(lay_out(piping, {320, 180}, {PaletteName::standard, 1.5F}).log.cards.size(), 1U);
}

// The test itself would see it.
TEST_F(LayoutTest, AFaultIsSeen) {
  OverlayState state = test::screen("piping");
  state.scenario = std::string(80, 'W');
  EXPECT_NE(faults_of(lay_out(state, {1280, 720}, {})).find("is cut off"), std::string::npos);
  LaidOut out = lay_out(test::screen("piping"), {1280, 720}, {});
  ASSERT_EQ(faults_of(out), "");
  out.log.cards.push_back(out.log.cards.front());
  EXPECT_NE(faults_of(out).find("card"), std::string::npos);
  out = lay_out(test::screen("piping"), {1280, 720}, {});
  out.log.words.back().area.at.x += 300.0F;
  EXPECT_NE(faults_of(out), "");
}

}  // namespace
}  // namespace fulcrum::ui
