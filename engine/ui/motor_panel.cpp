// Loads of motors: a bar to either side of the middle for each, and marks at the largest of the last moments.

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/ui/columns.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

constexpr float kHead = 36.0F;
constexpr float kRow = 19.0F;
constexpr float kHalf = 42.0F;  // of a bar, a motor's limit
constexpr float kBar = 8.0F;    // its height

// From the middle to a load, -1 to 1.
void draw_load(const Canvas& canvas, ImVec2 middle, double load, ImU32 colour) {
  const float x = kHalf * static_cast<float>(std::clamp(load, -1.0, 1.0));
  if (std::abs(x) < 0.5F) return;
  canvas.box({middle.x + std::min(x, 0.0F), middle.y - kBar / 2.0F}, {std::abs(x), kBar}, colour, 0.0F);
}

void draw_peak(const Canvas& canvas, ImVec2 middle, double peak) {
  const float x = kHalf * static_cast<float>(std::clamp(peak, -1.0, 1.0));
  if (std::abs(x) < 0.5F) return;
  const ImU32 colour = load_colour(canvas.colours(), static_cast<float>(std::abs(peak)));
  draw_load(canvas, middle, peak, with_alpha(colour, 110));
  canvas.box({middle.x + x - 1.0F, middle.y - kBar / 2.0F - 2.0F}, {2.0F, kBar + 4.0F}, colour, 0.0F);
}

}  // namespace

float motors_height(const OverlayState& state) {
  if (state.motors.empty()) return 0.0F;
  return kHead + static_cast<float>(state.motors.size()) * kRow + 6.0F;
}

void draw_motors(const Canvas& canvas, const OverlayState& state) {
  const auto [at, size] = columns_of(canvas, state).motors;
  if (!(size.x > 0.0F)) return;
  canvas.card(at, size);
  canvas.text(canvas.fonts().strong, {at.x + theme::kPadding, at.y + 9.0F}, theme::kText, "Motors");
  ImVec2 middle{at.x + size.x - theme::kPadding - kHalf, at.y + kHead + kRow / 2.0F};
  canvas.text(canvas.fonts().small, {middle.x - kHalf, at.y + 12.0F}, theme::kFaint, "-1", Align::centre);
  canvas.text(canvas.fonts().small, {middle.x, at.y + 12.0F}, theme::kFaint, "0", Align::centre);
  canvas.text(canvas.fonts().small, {middle.x + kHalf, at.y + 12.0F}, theme::kFaint, "1", Align::centre);
  for (const MotorBar& motor : state.motors) {
    const float name_width = size.x - 2.0F * (theme::kPadding + kHalf) - 8.0F;
    const std::string name = canvas.fitted(canvas.fonts().small, motor.name, name_width);
    const float height = canvas.measure(canvas.fonts().small, name).y;
    canvas.text(canvas.fonts().small, {at.x + theme::kPadding, middle.y - height / 2.0F}, theme::kSecondary,
                name);
    canvas.box({middle.x - kHalf, middle.y - kBar / 2.0F}, {2.0F * kHalf, kBar}, theme::kTrack, 2.0F);
    draw_peak(canvas, middle, motor.low);
    draw_peak(canvas, middle, motor.high);
    draw_load(canvas, middle, motor.load,
              load_colour(canvas.colours(), static_cast<float>(std::abs(motor.load))));
    canvas.line({middle.x, middle.y - kRow / 2.0F}, {middle.x, middle.y + kRow / 2.0F}, theme::kFaint, 1.0F);
    middle.y += kRow;
  }
}

}  // namespace fulcrum::ui
