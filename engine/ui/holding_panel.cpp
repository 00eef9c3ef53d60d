#include "engine/ui/holding_panel.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "engine/ui/columns.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"

namespace fulcrum::ui {
namespace {

using Part = HoldingPress::Part;

constexpr float kLength = kColumn - 2.0F * theme::kPadding;
// From the panel's top.
constexpr float kSlider = 46.0F, kSensor = 64.0F, kWall = 109.0F, kScale = 134.0F;
constexpr float kReach = 11.0F;  // a press this near to the slider counts as on it
constexpr float kScaleHeight = 12.0F, kMethodHeight = 21.0F;
constexpr double kWarnFrom = 0.8;  // of the limit

// What comes below moves up where there is no stiffness to show.
float inertia_at(const HoldingPanel& panel) {
  return panel.stiffness ? 171.0F : kWall;
}
float methods_at(const HoldingPanel& panel) {
  return inertia_at(panel) + 23.0F;
}
float height_of(const HoldingPanel& panel) {
  return inertia_at(panel) + 55.0F;
}

std::string words(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

void draw_slider(const Canvas& canvas, ImVec2 at, const HoldingPanel& panel) {
  canvas.box({at.x, at.y - 3.0F}, {kLength, 6.0F}, theme::kTrack, 3.0F);
  const double range = panel.high - panel.low;
  if (!(range > 0.0)) return;
  for (double mm = std::ceil(1e3 * panel.low / 10.0) * 10.0; mm <= 1e3 * panel.high + 1e-6; mm += 10.0) {
    const float x = kLength * static_cast<float>((1e-3 * mm - panel.low) / range);
    const bool longer = std::fmod(mm + 1e-6, 50.0) < 1e-3;
    canvas.line({at.x + x, at.y + 5.0F}, {at.x + x, at.y + (longer ? 10.0F : 7.5F)}, theme::kFaint, 1.0F);
  }
  const float x = kLength * static_cast<float>(std::clamp((panel.place - panel.low) / range, 0.0, 1.0));
  canvas.disc({at.x + x, at.y}, 7.5F, panel.sensed_well ? canvas.colours().accent : canvas.colours().warn);
  canvas.disc({at.x + x, at.y}, 3.0F, IM_COL32_WHITE);
}

// N/m, at the right end of the scale: a step beyond the stiffest level.
double scale_end(const HoldingPanel& panel) {
  const std::size_t n = panel.levels.size();
  if (n < 2) return 2.0 * std::max(*panel.stiffness, 1.0);
  return 2.0 * panel.levels[n - 1] - panel.levels[n - 2];
}

ImU32 wall_colour(const Palette& colours, const HoldingPanel& panel) {
  if (!(panel.limit > 0.0) || *panel.stiffness < kWarnFrom * panel.limit) return colours.accent;
  return *panel.stiffness < panel.limit ? colours.warn : colours.bad;
}

std::string wall_words(const HoldingPanel& panel) {
  const bool limited = panel.limit > 0.0;
  if (limited && *panel.stiffness >= panel.limit)
    return words("beyond the lever's %.0f N/m: it buzzes", panel.limit);
  if (panel.pending) return words("%.0f N/m once it lets go", *panel.pending);
  if (!panel.structure_known) return "how stiff the device is, is not known";
  if (!limited) return "nothing is touched";
  if (*panel.stiffness >= kWarnFrom * panel.limit) return words("close to the lever's %.0f N/m", panel.limit);
  return words("the lever bears %.0f N/m here", panel.limit);
}

void draw_scale(const Canvas& canvas, ImVec2 at, const HoldingPanel& panel) {
  const double stiffness = *panel.stiffness, end = scale_end(panel);
  const auto x_of = [&](double value) {
    return at.x + kLength * static_cast<float>(std::clamp(value / end, 0.0, 1.0));
  };
  canvas.box(at, {kLength, kScaleHeight}, theme::kTrack, 3.0F);
  const ImU32 colour = wall_colour(canvas.colours(), panel);
  canvas.box(at, {x_of(stiffness) - at.x, kScaleHeight}, with_alpha(colour, 150), 3.0F);
  for (const double level : panel.levels)
    canvas.line({x_of(level), at.y + 3.0F}, {x_of(level), at.y + kScaleHeight - 3.0F},
                level <= stiffness ? theme::kText : theme::kFaint, 1.4F);
  if (panel.pending)
    canvas.line({x_of(*panel.pending), at.y - 3.0F}, {x_of(*panel.pending), at.y + kScaleHeight + 3.0F},
                theme::kText, 2.0F);
  if (!(panel.limit > 0.0) || panel.limit > end) return;
  const float x = x_of(panel.limit);
  canvas.box({x, at.y}, {at.x + kLength - x, kScaleHeight}, with_alpha(canvas.colours().bad, 60), 0.0F);
  canvas.line({x, at.y - 4.0F}, {x, at.y + kScaleHeight + 4.0F}, canvas.colours().bad, 2.0F);
}

// Where a method's field ends, from the left: each is as wide as its word asks for.
float method_end(const HoldingPanel& panel, std::size_t method) {
  float all = 0.0F, up_to = 0.0F;
  for (std::size_t i = 0; i < panel.methods.size(); ++i) {
    all += static_cast<float>(panel.methods[i].size() + 3);
    if (i == method) up_to = all;
  }
  return kLength * up_to / all;
}

void draw_methods(const Canvas& canvas, ImVec2 at, const HoldingPanel& panel) {
  canvas.box(at, {kLength, kMethodHeight}, theme::kTrack, 4.0F);
  for (std::size_t i = 0; i < panel.methods.size(); ++i) {
    const float x = at.x + (i > 0 ? method_end(panel, i - 1) : 0.0F);
    const float each = at.x + method_end(panel, i) - x;
    const bool chosen = i == panel.method;
    if (chosen)
      canvas.box({x, at.y}, {each, kMethodHeight},
                 with_alpha(panel.faded ? canvas.colours().warn : canvas.colours().accent, 160), 4.0F);
    canvas.text(canvas.fonts().small, {x + each / 2.0F, at.y + 4.0F},
                chosen ? theme::kText : theme::kSecondary, panel.methods[i], Align::centre);
  }
}

}  // namespace

float holding_height(const OverlayState& state) {
  return state.holding ? height_of(*state.holding) : 0.0F;
}

void draw_holding(const Canvas& canvas, const OverlayState& state) {
  const Area area = columns_of(canvas, state).holding;
  if (!(area.size.x > 0.0F)) return;
  const ImVec2 at = area.at;
  const HoldingPanel& panel = *state.holding;
  const Fonts& fonts = canvas.fonts();
  const float left = at.x + theme::kPadding, right = left + kLength;
  canvas.card(at, area.size);
  // A heading, its value, and the keys that change it.
  const auto head = [&](float y, const char* title, const std::string& value, ImU32 colour, const char* key) {
    const float width = draw_key(canvas, {right, at.y + y - 2.0F}, key);
    canvas.text(fonts.strong, {left, at.y + y - 1.0F}, theme::kText, title);
    canvas.text(fonts.body, {right - width - 8.0F, at.y + y - 1.0F}, colour, value, Align::right);
  };
  head(11.0F, "Held at", words("%.0f mm", 1e3 * panel.place), theme::kText, "[ ]");
  draw_slider(canvas, {left, at.y + kSlider}, panel);

  draw_switch(canvas, {left, at.y + kSensor}, panel.measured);
  canvas.text(fonts.body, {left + kSwitch.x + 10.0F, at.y + kSensor - 1.0F},
              panel.measured ? theme::kText : theme::kFaint, "Measured");
  draw_key(canvas, {right, at.y + kSensor - 2.0F}, "H");
  canvas.text(fonts.small, {left, at.y + kSensor + 21.0F},
              panel.sensed_well ? theme::kSecondary : canvas.colours().warn,
              canvas.fitted(fonts.small, panel.sensed, kLength));

  if (panel.stiffness) {
    head(kWall, "Stiffness", words("%.0f N/m", *panel.stiffness), theme::kText, "- =");
    draw_scale(canvas, {left, at.y + kScale}, panel);
    const ImU32 colour = wall_colour(canvas.colours(), panel);
    canvas.text(fonts.small, {left, at.y + kScale + kScaleHeight + 4.0F},
                colour == canvas.colours().accent ? theme::kSecondary : colour,
                canvas.fitted(fonts.small, wall_words(panel), kLength));
  }

  if (panel.methods.empty()) {
    canvas.text(fonts.body, {left, at.y + inertia_at(panel) + 8.0F}, theme::kFaint,
                "Inertia is not made up for");
    return;
  }
  head(inertia_at(panel), "Inertia", panel.faded ? "faded" : "", canvas.colours().warn, "N");
  draw_methods(canvas, {left, at.y + methods_at(panel)}, panel);
}

std::optional<HoldingPress> pressed_holding(const OverlayState& state, const PanelPoint& press) {
  const auto [at, size] = columns_of(state, press.width, press.height).holding;
  if (!(size.x > 0.0F)) return std::nullopt;
  const HoldingPanel& panel = *state.holding;
  const float along = (press.x - at.x - theme::kPadding) / kLength, down = press.y - at.y;
  if (along < -0.04F || along > 1.04F) return std::nullopt;
  if (std::abs(down - kSlider) <= kReach) return HoldingPress{Part::place, dragged_place(state, press)};
  if (down >= kSensor - 4.0F && down <= kSensor + 20.0F)
    return HoldingPress{Part::measured, panel.measured ? 0.0 : 1.0};
  if (panel.stiffness && !panel.levels.empty() && down >= kScale - 5.0F &&
      down <= kScale + kScaleHeight + 5.0F) {
    const double wanted = static_cast<double>(along) * scale_end(panel);
    return HoldingPress{Part::stiffness, *std::ranges::min_element(panel.levels, {}, [&](double level) {
                          return std::abs(level - wanted);
                        })};
  }
  const float methods = methods_at(panel);
  if (down >= methods - 2.0F && down <= methods + kMethodHeight + 2.0F && !panel.methods.empty()) {
    std::size_t method = 0;
    while (method + 1 < panel.methods.size() && along * kLength > method_end(panel, method)) ++method;
    return HoldingPress{Part::method, static_cast<double>(method)};
  }
  return std::nullopt;
}

double dragged_place(const OverlayState& state, const PanelPoint& pointer) {
  const HoldingPanel& panel = *state.holding;
  const Area area = columns_of(state, pointer.width, pointer.height).holding;
  const float along = (pointer.x - area.at.x - theme::kPadding) / kLength;
  return panel.low + std::clamp(static_cast<double>(along), 0.0, 1.0) * (panel.high - panel.low);
}

}  // namespace fulcrum::ui
