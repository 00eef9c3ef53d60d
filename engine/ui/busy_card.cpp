// What is shown while there is no scene yet.

#include <algorithm>
#include <cmath>

#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {

void draw_busy(const Canvas& canvas, const Busy& busy) {
  const Fonts& fonts = canvas.fonts();
  constexpr float inset = 28.0F;
  const ImVec2 size{std::min(560.0F, canvas.width() - 2.0F * theme::kMargin), 150.0F};
  const ImVec2 at{(canvas.width() - size.x) / 2.0F, (canvas.height() - size.y) / 2.0F};
  const float left = at.x + inset;
  const float right = at.x + size.x - inset;
  canvas.card(at, size);
  ImFont* const font = canvas.widest({fonts.number, fonts.strong, fonts.small}, busy.title, right - left);
  canvas.text(font, {left, at.y + 22.0F}, theme::kText, canvas.fitted(font, busy.title, right - left));
  const auto done = static_cast<float>(std::clamp(busy.fraction, 0.0, 1.0));
  const std::string percent = std::to_string(static_cast<int>(100.0F * done)) + " %";
  canvas.text(fonts.body, {right, at.y + 64.0F}, theme::kText, percent, Align::right);
  canvas.text(fonts.body, {left, at.y + 64.0F}, theme::kSecondary,
              canvas.fitted(fonts.body, busy.what, right - left - 60.0F));
  constexpr float height = 8.0F;
  const ImVec2 bar{left, at.y + 90.0F};
  canvas.box(bar, {right - left, height}, theme::kTrack, height / 2.0F);
  if (done > 0.0F)
    canvas.box(bar, {std::max(height, done * (right - left)), height}, canvas.colours().accent,
               height / 2.0F);
  float y = at.y + 108.0F;
  for (const std::string& line : canvas.lines(fonts.small, busy.note, right - left, 2)) {
    canvas.text(fonts.small, {left, y}, theme::kSecondary, line);
    y += 16.0F;
  }
}

}  // namespace fulcrum::ui
