// Force and torque: an arc with a needle, the largest value of the last moments as a mark.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

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
const ImVec2 kSize{142.0F, 148.0F};

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
  canvas.arc(middle, outside, angle_at(kWarnFrom), angle_at(kBadFrom), theme::kWarn, 1.5F);
  canvas.arc(middle, outside, angle_at(kBadFrom), angle_at(1.0F), theme::kBad, 1.5F);
}

void draw_needle(const Canvas& canvas, ImVec2 middle, float fraction) {
  const float angle = angle_at(fraction);
  canvas.line(on_circle(middle, kRadius - 17.0F, angle), on_circle(middle, kRadius + kWidth / 2.0F, angle),
              theme::kText, 2.2F);
}

void draw_dial(const Canvas& canvas, ImVec2 at, const char* title, const char* unit, const Dial& dial,
               double peak) {
  const ImVec2 middle{at.x + kSize.x / 2.0F, at.y + 84.0F};
  const auto part = [&](double value) {
    return static_cast<float>(std::clamp(value / dial.limit, 0.0, 1.0));
  };
  const float fraction = part(dial.value);
  canvas.card(at, kSize);
  canvas.text(canvas.fonts().small, {middle.x, at.y + 8.0F}, theme::kSecondary, title, Align::centre);
  draw_scale(canvas, middle);
  if (fraction > 0.002F)
    canvas.arc(middle, kRadius, angle_at(0.0F), angle_at(fraction), load_colour(fraction), kWidth);
  const float peak_angle = angle_at(part(peak));
  canvas.line(on_circle(middle, kRadius - kWidth / 2.0F, peak_angle),
              on_circle(middle, kRadius + kWidth / 2.0F + 4.0F, peak_angle), load_colour(part(peak)), 2.2F);
  draw_needle(canvas, middle, fraction);
  const float height = canvas.measure(canvas.fonts().number, "0").y;
  canvas.text(canvas.fonts().number, {middle.x, middle.y - 0.55F * height}, theme::kText,
              number(dial.value, dial.limit), Align::centre);
  canvas.text(canvas.fonts().small, {middle.x, middle.y + 13.0F}, theme::kSecondary, unit, Align::centre);
  canvas.text(canvas.fonts().small, {middle.x, at.y + kSize.y - 24.0F}, theme::kFaint,
              "limit " + plain(dial.limit), Align::centre);
}

}  // namespace

ImU32 load_colour(float fraction) {
  return fraction >= kBadFrom ? theme::kBad : fraction >= kWarnFrom ? theme::kWarn : theme::kAccent;
}

float dials_width(const OverlayState& state) {
  const int dials = (state.force_N.limit > 0.0 ? 1 : 0) + (state.torque_Nm.limit > 0.0 ? 1 : 0);
  return dials == 0 ? 0.0F : dials == 1 ? kSize.x : 2.0F * kSize.x + kGap;
}

Area dials_area(const Canvas& canvas, const OverlayState& state) {
  const float width = dials_width(state);
  if (!(width > 0.0F)) return {};
  return {{theme::kMargin, canvas.height() - theme::kMargin - kSize.y}, {width, kSize.y}};
}

void draw_dials(const Canvas& canvas, const OverlayState& state, const Peaks& peaks) {
  ImVec2 at = dials_area(canvas, state).at;
  if (state.force_N.limit > 0.0) {
    draw_dial(canvas, at, "FORCE", "N", state.force_N, peaks.force_N);
    at.x += kSize.x + kGap;
  }
  if (state.torque_Nm.limit > 0.0)
    draw_dial(canvas, at, "TORQUE", "N\u00B7m", state.torque_Nm, peaks.torque_Nm);
}

}  // namespace fulcrum::ui
