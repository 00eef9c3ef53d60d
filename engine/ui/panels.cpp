#include "engine/ui/panels.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

std::string format(const char* pattern, double value) {
  char text[48];
  std::snprintf(text, sizeof(text), pattern, value);
  return text;
}

struct Fact {
  std::string name;
  std::string value;
  ImU32 colour = theme::kText;
};

constexpr float kHealthWidth = 214.0F;
constexpr float kFactRow = 20.0F;

std::vector<Fact> facts_of(const TickHealth& ticks) {
  const auto trouble = [](std::uint64_t count) { return count > 0 ? theme::kWarn : theme::kText; };
  if (ticks.rate_Hz <= 0) return {};  // not by the clock: there is nothing to tell
  return {
      {"Haptic rate", format("%.0f Hz", ticks.rate_Hz)},
      {"CPU per tick", ticks.cpu_p99_us > 0 ? format("%.0f", ticks.cpu_p50_us) + " / " +
                                                  format("%.0f \u00B5s", ticks.cpu_p99_us)
                                            : "-"},
      {"Late ticks", std::to_string(ticks.late), trouble(ticks.late)},
      {"Lost ticks", std::to_string(ticks.lost), ticks.lost > 0 ? theme::kBad : theme::kText},
  };
}

float key_column(const Canvas& canvas, const OverlayState& state) {
  float widest = 0.0F;
  for (const KeyLine& line : state.keys)
    widest = std::max(widest, canvas.measure(canvas.fonts().strong, line.key).x);
  return widest;
}

float text_width(const Canvas& canvas, const OverlayState& state, float column) {
  float widest = 0.0F;
  for (const KeyLine& line : state.keys)
    widest = std::max(widest, column + canvas.measure(canvas.fonts().body, line.meaning).x);
  for (const std::string& line : state.mapping)
    widest = std::max(widest, canvas.measure(canvas.fonts().body, line).x);
  return widest;
}

}  // namespace

float health_height(const OverlayState& state) {
  return 48.0F + static_cast<float>(facts_of(state.ticks).size()) * kFactRow;
}

void draw_health(const Canvas& canvas, const OverlayState& state) {
  constexpr float width = kHealthWidth;
  constexpr float row = kFactRow;
  const std::vector<Fact> facts = facts_of(state.ticks);
  const ImVec2 at{canvas.width() - theme::kMargin - width, theme::kMargin};
  const float right = at.x + width - theme::kPadding;
  canvas.card(at, {width, health_height(state)});

  const ImU32 light = state.force == Force::on        ? theme::kGood
                      : state.force == Force::stopped ? theme::kBad
                                                      : theme::kWarn;
  canvas.disc({at.x + theme::kPadding + 4.0F, at.y + 20.0F}, 4.0F, light);
  canvas.text(canvas.fonts().strong, {at.x + theme::kPadding + 16.0F, at.y + 11.0F}, theme::kText,
              canvas.fitted(canvas.fonts().strong, state.device, width - 2.0F * theme::kPadding - 16.0F));
  float y = at.y + 40.0F;
  for (const Fact& fact : facts) {
    canvas.text(canvas.fonts().body, {at.x + theme::kPadding, y}, theme::kSecondary, fact.name);
    canvas.text(canvas.fonts().body, {right, y}, fact.colour, fact.value, Align::right);
    y += row;
  }
}

void draw_message(const Canvas& canvas, const OverlayState& state) {
  if (state.message.empty()) return;
  ImFont* font = canvas.fonts().body;
  const std::string words = canvas.fitted(font, state.message, canvas.width() - 4.0F * theme::kMargin);
  const ImVec2 text = canvas.measure(font, words);
  const ImVec2 size{text.x + 32.0F, 34.0F};
  // Beside the dials where there is room, above them in a narrow picture.
  const float dials = theme::kMargin + 2.0F * 142.0F + 20.0F;
  const bool beside = canvas.width() / 2.0F - size.x / 2.0F > dials;
  const ImVec2 at{(canvas.width() - size.x) / 2.0F,
                  canvas.height() - theme::kMargin - size.y - (beside ? 0.0F : 158.0F)};
  canvas.card(at, size);
  canvas.text(font, {at.x + 16.0F, at.y + (size.y - text.y) / 2.0F}, theme::kText, words);
}

void draw_keys(const Canvas& canvas, const OverlayState& state) {
  if (!state.keys_visible) return;
  constexpr float row = 27.0F;
  constexpr float inset = 24.0F;
  const float column = key_column(canvas, state) + 40.0F;
  const float lines =
      static_cast<float>(state.keys.size()) * row +
      (state.mapping.empty() ? 0.0F : 18.0F + static_cast<float>(state.mapping.size()) * 21.0F);
  const ImVec2 size{std::max(300.0F, text_width(canvas, state, column) + 2.0F * inset),
                    58.0F + lines + 14.0F};
  const ImVec2 at{(canvas.width() - size.x) / 2.0F, (canvas.height() - size.y) / 2.0F};
  canvas.box(at, size, IM_COL32(12, 15, 19, 238), theme::kRounding);
  canvas.frame(at, size, theme::kCardEdge, theme::kRounding, 1.0F);
  canvas.text(canvas.fonts().strong, {at.x + inset, at.y + 18.0F}, theme::kText, "Keys");
  canvas.text(canvas.fonts().small, {at.x + size.x - inset, at.y + 20.0F}, theme::kFaint, "F1 closes this",
              Align::right);
  float y = at.y + 52.0F;
  for (const KeyLine& line : state.keys) {
    const ImVec2 key = canvas.measure(canvas.fonts().strong, line.key);
    canvas.box({at.x + inset, y}, {key.x + 16.0F, 22.0F}, theme::kTrack, 4.0F);
    canvas.text(canvas.fonts().strong, {at.x + inset + 8.0F, y + (22.0F - key.y) / 2.0F}, theme::kText,
                line.key);
    canvas.text(canvas.fonts().body, {at.x + inset + column, y + (22.0F - key.y) / 2.0F}, theme::kSecondary,
                line.meaning);
    y += row;
  }
  if (!state.mapping.empty()) {
    canvas.line({at.x + inset, y + 6.0F}, {at.x + size.x - inset, y + 6.0F}, theme::kCardEdge, 1.0F);
    y += 18.0F;
  }
  for (const std::string& line : state.mapping) {
    canvas.text(canvas.fonts().body, {at.x + inset, y}, theme::kSecondary, line);
    y += 21.0F;
  }
}

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
