// What is said across the picture while the force is off.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/ui/columns.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

constexpr const char* kReturning = "Force is coming back";

const char* how_to_resume(const OverlayState& state) {
  return state.pad ? "Press Enter, or A on the pad, to resume" : "Press Enter to resume";
}

void draw_stop(const Canvas& canvas, const OverlayState& state) {
  const auto [at, size] = columns_of(canvas, state).band;
  const Fonts& fonts = canvas.fonts();
  const float pulse = 0.5F + 0.5F * static_cast<float>(std::sin(2.0 * std::numbers::pi * state.time_s));
  const ImU32 edge = with_alpha(canvas.colours().stop_edge, static_cast<ImU32>(120.0F + 135.0F * pulse));
  canvas.card(at, size, canvas.colours().stop);
  canvas.frame(at, size, edge, 0.0F, 3.0F);
  const float middle = canvas.width() / 2.0F, room = canvas.width() - 60.0F;
  const std::string stopped = "Stopped: " + state.stop_reason, resume = how_to_resume(state);
  if (size.y < 60.0F) {
    const std::string all = stopped + (stopped.ends_with('.') ? " " : ". ") + resume + ".";
    ImFont* const font = canvas.widest({fonts.strong, fonts.small}, all, room);
    const float y = at.y + size.y - 20.0F - 0.5F * canvas.measure(font, "A").y;
    canvas.text(font, {middle, y}, IM_COL32_WHITE, canvas.fitted(font, all, room), Align::centre);
    return;
  }
  // In one line, large, or smaller in one or two.
  ImFont* const font = canvas.widest({fonts.banner, fonts.number}, stopped, room);
  const std::vector<std::string> lines = canvas.lines(font, stopped, room, font == fonts.banner ? 1 : 2);
  float y = at.y + (font == fonts.banner ? 18.0F : lines.size() == 1 ? 28.0F : 12.0F);
  for (const std::string& line : lines) {
    canvas.text(font, {middle, y}, IM_COL32_WHITE, line, Align::centre);
    y += 30.0F;
  }
  canvas.text(canvas.widest({fonts.number, fonts.strong}, resume, room), {middle, at.y + 76.0F},
              IM_COL32_WHITE, resume, Align::centre);
}

}  // namespace

Area returning_area(const Canvas& canvas, const OverlayState& state) {
  if (state.force != Force::returning || state.keys_visible || state.debrief) return {};
  const ImVec2 words = canvas.measure(canvas.fonts().strong, kReturning);
  const ImVec2 size{words.x + 36.0F, 36.0F};
  return {{(canvas.width() - size.x) / 2.0F, 0.16F * canvas.height()}, size};
}

void draw_banner(const Canvas& canvas, const OverlayState& state) {
  if (state.force == Force::stopped) return draw_stop(canvas, state);
  const Area area = returning_area(canvas, state);
  if (!(area.size.x > 0.0F)) return;
  canvas.card(area.at, area.size);
  const float high = canvas.measure(canvas.fonts().strong, kReturning).y;
  canvas.text(canvas.fonts().strong, {canvas.width() / 2.0F, area.at.y + (36.0F - high) / 2.0F},
              canvas.colours().warn, kReturning, Align::centre);
}

}  // namespace fulcrum::ui
