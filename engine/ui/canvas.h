#pragma once
// Shapes and text in scaled pixels: the few things that all panels are made of.

#include <imgui.h>

#include <initializer_list>
#include <string>
#include <vector>

#include "engine/ui/palette.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {

// Typefaces at their sizes, rasterised for one scale.
struct Fonts {
  ImFont* small = nullptr;
  ImFont* body = nullptr;
  ImFont* strong = nullptr;
  ImFont* number = nullptr;
  ImFont* banner = nullptr;
};

// A rectangle, in theme units.
struct Area {
  ImVec2 at{0.0F, 0.0F};
  ImVec2 size{0.0F, 0.0F};
};

// What a picture was laid out of, for a test to look at: theme units.
struct LayoutLog {
  struct Words {
    Area area;
    std::string words;
    std::size_t card;  // cards that were there before
  };
  std::vector<Area> cards;
  std::vector<Words> words;
  std::vector<std::string> cut;  // that had to be shortened
};

enum class Align { left, centre, right };

class Canvas {
public:
  // `size`: of the picture (pixels); `scale`: pixels for one unit of theme.h; `log`: null, and nothing is
  // noted.
  Canvas(ImDrawList& list, const Fonts& fonts, const Palette& colours, ImVec2 size, float scale,
         LayoutLog* log = nullptr)
      : list_(list), fonts_(fonts), colours_(colours), size_(size), scale_(scale), log_(log) {}

  const Fonts& fonts() const { return fonts_; }
  const Palette& colours() const { return colours_; }
  float width() const { return size_.x / scale_; }
  float height() const { return size_.y / scale_; }

  // A place in the picture, from its pixels.
  ImVec2 unit(float x_px, float y_px) const { return {x_px / scale_, y_px / scale_}; }

  // All coordinates in theme units, y down, angles in radians clockwise from the right.
  void card(ImVec2 at, ImVec2 size, ImU32 colour = theme::kCard) const;
  void box(ImVec2 at, ImVec2 size, ImU32 colour, float rounding) const;
  void frame(ImVec2 at, ImVec2 size, ImU32 colour, float rounding, float width) const;
  void line(ImVec2 from, ImVec2 to, ImU32 colour, float width) const;
  void arc(ImVec2 middle, float radius, float from_rad, float to_rad, ImU32 colour, float width) const;
  void disc(ImVec2 middle, float radius, ImU32 colour) const;
  void circle(ImVec2 middle, float radius, ImU32 colour, float width) const;
  void triangle(ImVec2 a, ImVec2 b, ImVec2 c, ImU32 colour) const;
  void text(ImFont* font, ImVec2 at, ImU32 colour, const std::string& words, Align align = Align::left) const;
  ImVec2 measure(ImFont* font, const std::string& words) const;

  // The words, with an ellipsis where they are wider than `width`.
  std::string fitted(ImFont* font, const std::string& words, float width) const;
  // The first of the fonts, the widest first, in which the words are no wider than `width`; else the last.
  ImFont* widest(std::initializer_list<ImFont*> fonts, const std::string& words, float width) const;
  // The words in lines no wider than `width`, broken at spaces and at their own line breaks; a word that is
  // wider has an ellipsis.
  std::vector<std::string> wrapped(ImFont* font, const std::string& words, float width) const;
  // The same in at most so many lines: the last has an ellipsis where there are more words.
  std::vector<std::string> lines(ImFont* font, const std::string& words, float width, std::size_t most) const;

private:
  ImVec2 px(ImVec2 at) const { return {at.x * scale_, at.y * scale_}; }

  ImDrawList& list_;
  const Fonts& fonts_;
  const Palette& colours_;
  ImVec2 size_;
  float scale_;
  LayoutLog* log_;
};

}  // namespace fulcrum::ui
