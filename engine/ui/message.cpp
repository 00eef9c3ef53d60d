// A sentence at the bottom of the picture.

#include <algorithm>

#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

constexpr float kSide = 16.0F;  // between the words and the card's edge
constexpr float kLine = 18.0F;
constexpr float kLeast = 260.0F;  // narrower than this, the words go above the dials

struct Words {
  std::vector<std::string> lines;
  Area area;
};

Words laid_out(const Canvas& canvas, const OverlayState& state) {
  if (state.message.empty()) return {};
  // Between the dials and the motors, or above both.
  const Area dials = dials_area(canvas, state), motors = motors_area(canvas, state);
  float left = std::max(theme::kMargin, dials.at.x + dials.size.x + theme::kMargin);
  float right = motors.size.x > 0.0F ? motors.at.x - theme::kMargin : canvas.width() - theme::kMargin;
  float bottom = canvas.height() - theme::kMargin;
  if (right - left < kLeast) {
    bottom -= std::max(dials.size.y, motors.size.y) + 10.0F;
    left = theme::kMargin;
    right = canvas.width() - theme::kMargin;
  }
  Words words{canvas.wrapped(canvas.fonts().body, state.message, right - left - 2.0F * kSide), {}};
  float widest = 0.0F;
  for (const std::string& line : words.lines)
    widest = std::max(widest, canvas.measure(canvas.fonts().body, line).x);
  const ImVec2 size{widest + 2.0F * kSide, 16.0F + kLine * static_cast<float>(words.lines.size())};
  // In the middle of the picture where that is free.
  const float middle = std::clamp(canvas.width() / 2.0F, left + size.x / 2.0F, right - size.x / 2.0F);
  words.area = {{middle - size.x / 2.0F, bottom - size.y}, size};
  return words;
}

}  // namespace

Area message_area(const Canvas& canvas, const OverlayState& state) {
  return laid_out(canvas, state).area;
}

void draw_message(const Canvas& canvas, const OverlayState& state) {
  const Words words = laid_out(canvas, state);
  if (words.lines.empty()) return;
  canvas.card(words.area.at, words.area.size);
  float y = words.area.at.y + 8.0F;
  for (const std::string& line : words.lines) {
    canvas.text(canvas.fonts().body, {words.area.at.x + words.area.size.x / 2.0F, y}, theme::kText, line,
                Align::centre);
    y += kLine;
  }
}

}  // namespace fulcrum::ui
