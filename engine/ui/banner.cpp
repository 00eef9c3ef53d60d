// What is said across the picture while the force is off.

#include <cmath>
#include <numbers>

#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {

void draw_banner(const Canvas& canvas, const OverlayState& state) {
  if (state.force == Force::on) return;
  if (state.force == Force::returning) {
    const char* words = "Force is coming back";
    const ImVec2 text = canvas.measure(canvas.fonts().strong, words);
    const ImVec2 at{(canvas.width() - text.x) / 2.0F - 18.0F, 0.16F * canvas.height()};
    canvas.card(at, {text.x + 36.0F, 36.0F});
    canvas.text(canvas.fonts().strong, {canvas.width() / 2.0F, at.y + (36.0F - text.y) / 2.0F}, theme::kWarn,
                words, Align::centre);
    return;
  }
  constexpr float height = 118.0F;
  const ImVec2 at{-4.0F, 0.30F * canvas.height() - height / 2.0F};
  const float pulse = 0.5F + 0.5F * static_cast<float>(std::sin(2.0 * std::numbers::pi * state.time_s));
  const auto edge_alpha = static_cast<ImU32>(120.0F + 135.0F * pulse);
  const ImU32 edge = (theme::kStopEdge & ~IM_COL32_A_MASK) | (edge_alpha << IM_COL32_A_SHIFT);
  canvas.box(at, {canvas.width() + 8.0F, height}, theme::kStop, 0.0F);
  canvas.frame(at, {canvas.width() + 8.0F, height}, edge, 0.0F, 3.0F);
  const std::string reason =
      canvas.fitted(canvas.fonts().banner, "Stopped: " + state.stop_reason, canvas.width() - 60.0F);
  canvas.text(canvas.fonts().banner, {canvas.width() / 2.0F, at.y + 18.0F}, IM_COL32_WHITE, reason,
              Align::centre);
  canvas.text(canvas.fonts().number, {canvas.width() / 2.0F, at.y + 74.0F}, IM_COL32(255, 232, 230, 255),
              "Press Enter to resume", Align::centre);
}

}  // namespace fulcrum::ui
