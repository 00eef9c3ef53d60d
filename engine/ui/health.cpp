// The device in the hand, and how the haptic thread is doing.

#include <algorithm>
#include <cstdio>

#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

constexpr float kWidth = 214.0F;
constexpr float kHead = 48.0F;
constexpr float kHintRow = 16.0F;
constexpr float kRow = 20.0F;

struct Fact {
  std::string name;
  std::string value;
  ImU32 colour = theme::kText;
};

std::string format(const char* pattern, double value) {
  char text[48];
  std::snprintf(text, sizeof(text), pattern, value);
  return text;
}

std::vector<Fact> facts_of(const OverlayState& state) {
  const TickHealth& ticks = state.ticks;
  // Not by the clock: there is nothing to tell.
  if (!state.figures_visible || ticks.rate_Hz <= 0) return {};
  return {
      {"Haptic rate", format("%.0f Hz", ticks.rate_Hz)},
      {"CPU per tick", ticks.cpu_p99_us > 0 ? format("%.0f", ticks.cpu_p50_us) + " / " +
                                                  format("%.0f \u00B5s", ticks.cpu_p99_us)
                                            : "-"},
      {"Late ticks", std::to_string(ticks.late), ticks.late > 0 ? theme::kWarn : theme::kText},
      {"Lost ticks", std::to_string(ticks.lost), ticks.lost > 0 ? theme::kBad : theme::kText},
      {"Frames", ticks.frames_per_s > 0 ? format("%.0f /s", ticks.frames_per_s) : "-"},
  };
}

bool has_hint(const OverlayState& state) {
  return !state.hint.empty() || !state.view.empty();
}

constexpr const char* kTrouble = "Haptics runs late (F3)";

}  // namespace

float health_height(const OverlayState& state) {
  return kHead + (has_hint(state) ? kHintRow : 0.0F) + static_cast<float>(facts_of(state).size()) * kRow;
}

Area health_area(const Canvas& canvas, const OverlayState& state) {
  return {{canvas.width() - theme::kMargin - kWidth, theme::kMargin}, {kWidth, health_height(state)}};
}

void draw_health(const Canvas& canvas, const OverlayState& state) {
  const Fonts& fonts = canvas.fonts();
  const Area area = health_area(canvas, state);
  const ImVec2 at = area.at;
  const float left = at.x + theme::kPadding, right = at.x + kWidth - theme::kPadding;
  canvas.card(at, area.size);

  const ImU32 light = state.force == Force::on        ? theme::kGood
                      : state.force == Force::stopped ? theme::kBad
                                                      : theme::kWarn;
  canvas.disc({left + 4.0F, at.y + 20.0F}, 4.0F, light);
  canvas.text(fonts.strong, {left + 16.0F, at.y + 11.0F}, theme::kText,
              canvas.fitted(fonts.strong, state.device, right - left - 16.0F));
  float y = at.y + 40.0F;
  if (has_hint(state)) {
    const float hint = state.hint.empty() ? 0.0F : canvas.measure(fonts.small, state.hint).x + 12.0F;
    canvas.text(fonts.small, {left, y - 6.0F}, theme::kSecondary, state.hint);
    canvas.text(fonts.small, {right, y - 6.0F}, theme::kSecondary,
                canvas.fitted(fonts.small, state.view, right - left - hint), Align::right);
    y += kHintRow;
  }
  for (const Fact& fact : facts_of(state)) {
    canvas.text(fonts.body, {left, y}, theme::kSecondary, fact.name);
    canvas.text(fonts.body, {right, y}, fact.colour, fact.value, Align::right);
    y += kRow;
  }
}

Area trouble_area(const Canvas& canvas, const OverlayState& state) {
  if (!state.ticks.trouble || state.figures_visible) return {};
  const ImVec2 words = canvas.measure(canvas.fonts().small, kTrouble);
  const ImVec2 size{words.x + 20.0F, words.y + 10.0F};
  return {{health_area(canvas, state).at.x - 10.0F - size.x, theme::kMargin}, size};
}

void draw_trouble(const Canvas& canvas, const OverlayState& state) {
  const Area area = trouble_area(canvas, state);
  if (!(area.size.x > 0.0F)) return;
  canvas.card(area.at, area.size);
  canvas.text(canvas.fonts().small, {area.at.x + 10.0F, area.at.y + 5.0F}, theme::kBad, kTrouble);
}

}  // namespace fulcrum::ui
