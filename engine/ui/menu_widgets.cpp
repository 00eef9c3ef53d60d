#include "engine/ui/menu_widgets.h"

#include <algorithm>

#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

constexpr float kNamePart = 0.27F;  // of a row's width
constexpr float kNameMost = 120.0F;
constexpr float kArrow = 28.0F;  // width of what is pressed
constexpr float kPad = 8.0F;

float name_width(const Area& row) {
  return std::min(kNameMost, kNamePart * row.size.x);
}

void draw_arrow(const Canvas& canvas, const Area& area, int side, ImU32 colour) {
  const float x = area.at.x + area.size.x / 2.0F, y = area.at.y + area.size.y / 2.0F;
  const auto direction = static_cast<float>(side);
  canvas.triangle({x + 4.0F * direction, y}, {x - 3.0F * direction, y - 6.0F},
                  {x - 3.0F * direction, y + 6.0F}, colour);
}

// What was written last, as much as there is room for.
std::string end_that_fits(const Canvas& canvas, ImFont* font, std::string words, float width) {
  if (canvas.measure(font, words).x <= width) return words;
  while (!words.empty() && canvas.measure(font, "..." + words).x > width) {
    const auto next = std::find_if(words.begin() + 1, words.end(), [](char c) {
      return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;  // UTF-8: a letter begins
    });
    words.erase(words.begin(), next);
  }
  return "..." + words;
}

}  // namespace

bool holds(const Area& area, ImVec2 point) {
  return point.x >= area.at.x && point.y >= area.at.y && point.x < area.at.x + area.size.x &&
         point.y < area.at.y + area.size.y;
}

Area arrow_area(const Area& row, int side) {
  const float left = side < 0 ? row.at.x + name_width(row) : row.at.x + row.size.x - kArrow;
  return {{left, row.at.y}, {kArrow, row.size.y}};
}

int side_of(const Area& row, ImVec2 point) {
  for (const int side : {-1, 1})
    if (holds(arrow_area(row, side), point)) return side;
  return 0;
}

void draw_menu_row(const Canvas& canvas, const Area& row, const StartPage::Setting& setting, bool focused) {
  const ImVec2 at = row.at, size = row.size;
  const Fonts& fonts = canvas.fonts();
  const ImU32 accent = canvas.colours().accent;
  if (focused) canvas.frame(at, size, accent, 6.0F, 2.0F);
  const auto top = [&](ImFont* font) { return at.y + (size.y - canvas.measure(font, "A").y) / 2.0F; };
  const float named = name_width(row) - kPad - 2.0F;
  ImFont* const name_font = canvas.widest({fonts.body, fonts.small}, setting.name, named);
  canvas.text(name_font, {at.x + kPad, top(name_font)}, theme::kSecondary,
              canvas.fitted(name_font, setting.name, named));
  if (!setting.written)
    for (const int side : {-1, 1})
      draw_arrow(canvas, arrow_area(row, side), side, focused ? accent : theme::kFaint);
  const float left = arrow_area(row, -1).at.x + kArrow, right = arrow_area(row, 1).at.x;
  ImFont* const font = canvas.widest({fonts.strong, fonts.small}, setting.value, right - left);
  const std::string shown = setting.written ? end_that_fits(canvas, font, setting.value, right - left)
                                            : canvas.fitted(font, setting.value, right - left);
  const float middle = (left + right) / 2.0F;
  canvas.text(font, {middle, top(font)}, theme::kText, shown, Align::centre);
  if (setting.written) {
    const float caret = middle + canvas.measure(font, shown).x / 2.0F + 3.0F;
    canvas.line({caret, at.y + 7.0F}, {caret, at.y + size.y - 7.0F}, accent, 2.0F);
  }
}

void draw_menu_button(const Canvas& canvas, const Area& area, const std::string& word, bool focused,
                      bool leads) {
  canvas.box(area.at, area.size, leads ? canvas.colours().lead : theme::kButton, 7.0F);
  if (focused) canvas.frame(area.at, area.size, theme::kText, 7.0F, 2.0F);
  ImFont* const font = canvas.fonts().strong;
  const float y = area.at.y + (area.size.y - canvas.measure(font, "A").y) / 2.0F;
  canvas.text(font, {area.at.x + area.size.x / 2.0F, y}, theme::kText, word, Align::centre);
}

}  // namespace fulcrum::ui
