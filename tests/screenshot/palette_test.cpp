// Both palettes' own colours, as people see them who lack a kind of cone.

#include "engine/ui/palette.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "colour_vision.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

using test::Vision;

// CIE 1976: more than ten times what is just noticed.
constexpr float kApart = 30.0F;

struct Named {
  std::string name;
  glm::vec3 linear;
};

glm::vec3 linear_of(ImU32 colour) {
  const auto part = [&](int shift) { return static_cast<float>((colour >> shift) & 0xFFU) / 255.0F; };
  return test::linear_of({part(IM_COL32_R_SHIFT), part(IM_COL32_G_SHIFT), part(IM_COL32_B_SHIFT)});
}

// Colours of which any two have to be told apart.
std::vector<std::vector<Named>> states_of(const Palette& palette) {
  return {{{"accent", linear_of(palette.accent)},
           {"good", linear_of(palette.good)},
           {"warn", linear_of(palette.warn)},
           {"bad", linear_of(palette.bad)}},
          {{"next", palette.markers.next},
           {"dwelling", palette.markers.dwelling},
           {"done", palette.markers.done}}};
}

struct Nearest {
  float distance = 1e6F;
  std::string pair;
};

Nearest nearest(const Palette& palette, Vision vision) {
  Nearest found;
  for (const std::vector<Named>& states : states_of(palette))
    for (std::size_t i = 0; i < states.size(); ++i)
      for (std::size_t j = i + 1; j < states.size(); ++j) {
        const float distance = test::distance_seen(states[i].linear, states[j].linear, vision);
        if (distance < found.distance) found = {distance, states[i].name + " and " + states[j].name};
      }
  return found;
}

TEST(Palette, OfColourBlindnessTellsItsStatesApartForAllEyes) {
  for (const Vision vision : test::kVisions) {
    const Nearest pair = nearest(palette(PaletteName::colour_blind), vision);
    EXPECT_GE(pair.distance, kApart) << pair.pair << ", vision " << static_cast<int>(vision);
  }
}

TEST(Palette, TheStandardOneTellsItsStatesApartForMost) {
  const Nearest pair = nearest(palette(PaletteName::standard), Vision::normal);
  EXPECT_GE(pair.distance, kApart) << pair.pair;
}

// The measure has teeth: of red and green, and of the standard palette, it says that they do not do.
TEST(Palette, RedAndGreenAreNotToldApart) {
  Palette red_and_green = palette(PaletteName::colour_blind);
  red_and_green.good = IM_COL32(66, 206, 138, 255);
  red_and_green.bad = IM_COL32(255, 92, 88, 255);
  for (const Vision vision : {Vision::protanope, Vision::deuteranope}) {
    EXPECT_LT(nearest(red_and_green, vision).distance, kApart);
    EXPECT_LT(nearest(palette(PaletteName::standard), vision).distance, kApart);
  }
}

// Known answers, so that the simulation itself is right: greys stay, and red and green of equal lightness
// come together.
TEST(Palette, TheSimulationKeepsGreysAndMixesRedWithGreen) {
  for (const Vision vision : test::kVisions) {
    const glm::vec3 grey(0.4F);
    EXPECT_LT(glm::distance(test::as_seen(grey, vision), grey), 2e-3F);
  }
  const glm::vec3 red(0.55F, 0.10F, 0.05F), green(0.10F, 0.22F, 0.05F);
  const float seen = test::distance_seen(red, green, Vision::deuteranope);
  EXPECT_LT(seen, 0.3F * test::distance_seen(red, green, Vision::normal));
  EXPECT_NEAR(test::lab_of({1, 1, 1}).x, 100.0F, 0.01F);
  EXPECT_NEAR(test::contrast({1, 1, 1}, {0, 0, 0}), 21.0F, 0.01F);
}

// WCAG 2.1: 4.5 to 1 for text, 3 to 1 for what is large or no text.
TEST(Palette, WhatIsWrittenStandsOutFromItsCard) {
  const glm::vec3 card = linear_of(theme::kCard), white(1.0F);
  EXPECT_GE(test::contrast(linear_of(theme::kText), card), 7.0F);
  for (const ImU32 colour : {theme::kSecondary, theme::kFaint})
    EXPECT_GE(test::contrast(linear_of(colour), card), 4.5F);
  for (const PaletteName name : {PaletteName::standard, PaletteName::colour_blind}) {
    const Palette& colours = palette(name);
    for (const ImU32 colour : {colours.accent, colours.good, colours.warn, colours.bad})
      EXPECT_GE(test::contrast(linear_of(colour), card), 4.5F);
    EXPECT_GE(test::contrast(linear_of(colours.stop), white), 4.5F);
    EXPECT_GE(test::contrast(linear_of(colours.lead), white), 4.5F);
  }
}

}  // namespace
}  // namespace fulcrum::ui
