// Force and torque: an arc with a needle, the largest value of the last moments as a mark, and a band of what
// feels the same.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "engine/ui/columns.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"
#include "engine/ui/weber.h"

namespace fulcrum::ui {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kStart_rad = 0.80F * kPi;  // lower left
constexpr float kSweep_rad = 1.40F * kPi;  // clockwise to the lower right
constexpr float kWarnFrom = 0.70F;         // of the limit
constexpr float kBadFrom = 0.90F;
constexpr float kRadius = 52.0F;
constexpr float kWidth = 7.0F;
constexpr float kGap = 10.0F;  // between the dials
constexpr float kFelt = 4.0F;  // the band of what feels the same, inside the scale
const ImVec2 kSize{142.0F, 148.0F};
constexpr float kSlim = 42.0F;  // height of a bar in place of an arc

float angle_at(float fraction) {
  return kStart_rad + kSweep_rad * fraction;
}

ImVec2 on_circle(ImVec2 middle, float radius, float angle) {
  return {middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)};
}

std::string number(double value, double limit) {
  char text[32];
  std::snprintf(text, sizeof(text), limit < 1.0 ? "%.3f" : limit < 10.0 ? "%.2f" : "%.1f", value);
  return text;
}

// The limit without digits that say nothing: 3.3, 0.2, 8.
std::string plain(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", value);
  return text;
}

void draw_scale(const Canvas& canvas, ImVec2 middle) {
  canvas.arc(middle, kRadius, angle_at(0.0F), angle_at(1.0F), theme::kTrack, kWidth);
  // Where it becomes serious, thin and outside, so that it is known before it is reached.
  const float outside = kRadius + kWidth / 2.0F + 2.5F;
  canvas.arc(middle, outside, angle_at(kWarnFrom), angle_at(kBadFrom), canvas.colours().warn, 1.5F);
  canvas.arc(middle, outside, angle_at(kBadFrom), angle_at(1.0F), canvas.colours().bad, 1.5F);
}

// The part of the scale that feels like the value.
void draw_felt_same(const Canvas& canvas, ImVec2 middle, const FeltSame& same, double limit) {
  const auto angle = [&](double value) {
    return angle_at(static_cast<float>(std::clamp(value / limit, 0.0, 1.0)));
  };
  canvas.arc(middle, kRadius - kWidth / 2.0F - 1.0F - kFelt / 2.0F, angle(same.low), angle(same.high),
             theme::kSecondary, kFelt);
}

void draw_needle(const Canvas& canvas, ImVec2 middle, float fraction) {
  const float angle = angle_at(fraction);
  canvas.line(on_circle(middle, kRadius - 17.0F, angle), on_circle(middle, kRadius + kWidth / 2.0F, angle),
              theme::kText, 2.2F);
}

void draw_dial(const Canvas& canvas, ImVec2 at, const char* title, const char* unit, const Dial& dial,
               double weber, double peak) {
  const ImVec2 middle{at.x + kSize.x / 2.0F, at.y + 84.0F};
  const auto part = [&](double value) {
    return static_cast<float>(std::clamp(value / dial.limit, 0.0, 1.0));
  };
  const float fraction = part(dial.value);
  canvas.card(at, kSize);
  canvas.text(canvas.fonts().small, {middle.x, at.y + 8.0F}, theme::kSecondary, title, Align::centre);
  draw_scale(canvas, middle);
  if (fraction > 0.002F)
    canvas.arc(middle, kRadius, angle_at(0.0F), angle_at(fraction), load_colour(canvas.colours(), fraction),
               kWidth);
  const float peak_angle = angle_at(part(peak));
  canvas.line(on_circle(middle, kRadius - kWidth / 2.0F, peak_angle),
              on_circle(middle, kRadius + kWidth / 2.0F + 4.0F, peak_angle),
              load_colour(canvas.colours(), part(peak)), 2.2F);
  if (fraction > 0.002F) draw_felt_same(canvas, middle, felt_same(dial.value, weber), dial.limit);
  draw_needle(canvas, middle, fraction);
  const float height = canvas.measure(canvas.fonts().number, "0").y;
  canvas.text(canvas.fonts().number, {middle.x, middle.y - 0.55F * height}, theme::kText,
              number(dial.value, dial.limit), Align::centre);
  canvas.text(canvas.fonts().small, {middle.x, middle.y + 13.0F}, theme::kSecondary, unit, Align::centre);
  canvas.text(canvas.fonts().small, {middle.x, at.y + kSize.y - 24.0F}, theme::kFaint,
              "limit " + plain(dial.limit), Align::centre);
}

// The same where there is no room for an arc.
void draw_bar(const Canvas& canvas, ImVec2 at, const char* title, const char* unit, const Dial& dial,
              double weber, double peak) {
  const Fonts& fonts = canvas.fonts();
  const float left = at.x + 10.0F, width = kSize.x - 20.0F, top = at.y + kSlim - 13.0F;
  const auto part = [&](double value) {
    return static_cast<float>(std::clamp(value / dial.limit, 0.0, 1.0));
  };
  const float fraction = part(dial.value);
  canvas.card(at, {kSize.x, kSlim});
  canvas.text(fonts.small, {left, at.y + 8.0F}, theme::kSecondary, title);
  canvas.text(fonts.small, {left + width, at.y + 8.0F}, theme::kText,
              number(dial.value, dial.limit) + " " + unit, Align::right);
  canvas.box({left, top}, {width, 5.0F}, theme::kTrack, 0.0F);
  canvas.box({left + width * kWarnFrom, top + 6.0F}, {width * (kBadFrom - kWarnFrom), 1.5F},
             canvas.colours().warn, 0.0F);
  canvas.box({left + width * kBadFrom, top + 6.0F}, {width * (1.0F - kBadFrom), 1.5F}, canvas.colours().bad,
             0.0F);
  canvas.box({left, top}, {width * fraction, 5.0F}, load_colour(canvas.colours(), fraction), 0.0F);
  if (fraction > 0.002F) {
    const FeltSame same = felt_same(dial.value, weber);
    canvas.box({left + width * part(same.low), top - 3.0F},
               {width * (part(same.high) - part(same.low)), 2.0F}, theme::kSecondary, 0.0F);
  }
  canvas.box({left + width * part(peak) - 1.0F, top - 2.0F}, {2.0F, 9.0F},
             load_colour(canvas.colours(), part(peak)), 0.0F);
}

}  // namespace

ImU32 load_colour(const Palette& colours, float fraction) {
  return fraction >= kBadFrom ? colours.bad : fraction >= kWarnFrom ? colours.warn : colours.accent;
}

float dials_width(const OverlayState& state, float room) {
  const int dials = (state.force_N.limit > 0.0 ? 1 : 0) + (state.torque_Nm.limit > 0.0 ? 1 : 0);
  if (dials == 2 && 2.0F * kSize.x + kGap <= room) return 2.0F * kSize.x + kGap;
  return dials > 0 && kSize.x <= room ? kSize.x : 0.0F;
}

float dials_height(bool slim) {
  return slim ? kSlim : kSize.y;
}

void draw_dials(const Canvas& canvas, const OverlayState& state, const Peaks& peaks) {
  const Columns columns = columns_of(canvas, state);
  ImVec2 at = columns.dials.at;
  const float right = at.x + columns.dials.size.x;
  const auto draw = [&](const char* title, const char* unit, const Dial& dial, double weber, double peak) {
    if (!(dial.limit > 0.0) || at.x + kSize.x > right + 0.5F) return;
    if (columns.slim_dials)
      draw_bar(canvas, at, title, unit, dial, weber, peak);
    else
      draw_dial(canvas, at, title, unit, dial, weber, peak);
    at.x += kSize.x + kGap;
  };
  draw("FORCE", "N", state.force_N, kForceWeber, peaks.force_N);
  draw("TORQUE", "N\u00B7m", state.torque_Nm, kTorqueWeber, peaks.torque_Nm);
}

}  // namespace fulcrum::ui
