#include "engine/ui/widgets.h"

#include "engine/ui/theme.h"

namespace fulcrum::ui {

void draw_switch(const Canvas& canvas, ImVec2 at, bool on) {
  const float radius = kSwitch.y / 2.0F;
  canvas.box(at, kSwitch, on ? canvas.colours().accent : theme::kTrack, radius);
  canvas.disc({on ? at.x + kSwitch.x - radius : at.x + radius, at.y + radius}, radius - 3.0F,
              on ? IM_COL32_WHITE : theme::kSecondary);
}

float draw_key(const Canvas& canvas, ImVec2 right, const std::string& key) {
  const float width = canvas.measure(canvas.fonts().strong, key).x + 12.0F;
  canvas.box({right.x - width, right.y}, {width, 20.0F}, theme::kTrack, 4.0F);
  canvas.text(canvas.fonts().strong, {right.x - width + 6.0F, right.y + 1.0F}, theme::kSecondary, key);
  return width;
}

}  // namespace fulcrum::ui
