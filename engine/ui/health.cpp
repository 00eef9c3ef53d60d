// The device in the hand, and how the haptic thread is doing.

#include <algorithm>
#include <cstdio>

#include "engine/ui/columns.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

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

// Not by the clock: there is nothing to tell.
bool has_facts(const OverlayState& state) {
  return state.figures_visible && state.ticks.rate_Hz > 0;
}

constexpr float kFacts = 5.0F;

std::vector<Fact> facts_of(const Palette& colours, const OverlayState& state) {
  const TickHealth& ticks = state.ticks;
  if (!has_facts(state)) return {};
  return {
      {"Haptic rate", format("%.0f Hz", ticks.rate_Hz)},
      {"CPU per tick", ticks.cpu_p99_us > 0 ? format("%.0f", ticks.cpu_p50_us) + " / " +
                                                  format("%.0f \u00B5s", ticks.cpu_p99_us)
                                            : "-"},
      {"Late ticks", std::to_string(ticks.late), ticks.late > 0 ? colours.warn : theme::kText},
      {"Lost ticks", std::to_string(ticks.lost), ticks.lost > 0 ? colours.bad : theme::kText},
      {"Frames", ticks.frames_per_s > 0 ? format("%.0f /s", ticks.frames_per_s) : "-"},
  };
}

bool has_hint(const OverlayState& state) {
  return !state.hint.empty() || !state.view.empty();
}

constexpr const char* kTrouble = "Haptics runs late (F3)";
constexpr float kBesideFrom = 720.0F;  // width of a picture

bool has_trouble(const OverlayState& state) {
  return state.ticks.trouble && !state.figures_visible;
}

// Elsewhere it takes the place of the hints.
bool trouble_is_beside(const Canvas& canvas) {
  return canvas.width() >= kBesideFrom;
}

// Round while all is well, a square while the force is off, a ring while it comes back.
void draw_light(const Canvas& canvas, ImVec2 middle, Force force) {
  const Palette& colours = canvas.colours();
  if (force == Force::on) canvas.disc(middle, 4.0F, colours.good);
  if (force == Force::returning) canvas.circle(middle, 4.0F, colours.warn, 2.0F);
  if (force == Force::stopped)
    canvas.box({middle.x - 4.0F, middle.y - 4.0F}, {8.0F, 8.0F}, colours.bad, 0.0F);
}

}  // namespace

float health_height(const OverlayState& state, bool hints) {
  return kHead + (hints && has_hint(state) ? kHintRow : 0.0F) + (has_facts(state) ? kFacts * kRow : 0.0F);
}

void draw_health(const Canvas& canvas, const OverlayState& state) {
  const Fonts& fonts = canvas.fonts();
  const Columns columns = columns_of(canvas, state);
  const auto [at, size] = columns.health;
  if (!(size.x > 0.0F)) return;
  const float left = at.x + theme::kPadding, right = at.x + size.x - theme::kPadding;
  canvas.card(at, size);
  draw_light(canvas, {left + 4.0F, at.y + 20.0F}, state.force);
  ImFont* const font = canvas.widest({fonts.strong, fonts.small}, state.device, right - left - 16.0F);
  canvas.text(font, {left + 16.0F, at.y + 20.0F - 0.5F * canvas.measure(font, "A").y}, theme::kText,
              canvas.fitted(font, state.device, right - left - 16.0F));
  float y = at.y + 40.0F;
  if (columns.hints && has_hint(state)) {
    if (has_trouble(state) && !trouble_is_beside(canvas)) {
      canvas.text(fonts.small, {left, y - 6.0F}, canvas.colours().bad, kTrouble);
    } else {
      const float hint = state.hint.empty() ? 0.0F : canvas.measure(fonts.small, state.hint).x + 12.0F;
      canvas.text(fonts.small, {left, y - 6.0F}, theme::kSecondary, state.hint);
      canvas.text(fonts.small, {right, y - 6.0F}, theme::kSecondary,
                  canvas.fitted(fonts.small, state.view, right - left - hint), Align::right);
    }
    y += kHintRow;
  }
  for (const Fact& fact : facts_of(canvas.colours(), state)) {
    canvas.text(fonts.body, {left, y}, theme::kSecondary, fact.name);
    canvas.text(fonts.body, {right, y}, fact.colour, fact.value, Align::right);
    y += kRow;
  }
}

Area trouble_area(const Canvas& canvas, const OverlayState& state) {
  const Area health = columns_of(canvas, state).health;
  if (!has_trouble(state) || !trouble_is_beside(canvas) || !(health.size.x > 0.0F)) return {};
  const ImVec2 words = canvas.measure(canvas.fonts().small, kTrouble);
  const ImVec2 size{words.x + 20.0F, words.y + 10.0F};
  return unless_covered(canvas, state, {{health.at.x - kPanelGap - size.x, health.at.y}, size});
}

void draw_trouble(const Canvas& canvas, const OverlayState& state) {
  const Area area = trouble_area(canvas, state);
  if (!(area.size.x > 0.0F)) return;
  canvas.card(area.at, area.size);
  canvas.text(canvas.fonts().small, {area.at.x + 10.0F, area.at.y + 5.0F}, canvas.colours().bad, kTrouble);
}

}  // namespace fulcrum::ui
