// Marks of touch in the scene, and the frame of a second view with its own.

#include <algorithm>
#include <cmath>

#include "engine/ui/areas.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

constexpr float kAspect = 1.6F;  // width over height
constexpr float kShare = 0.25F;  // of the picture's width
constexpr float kLeastWide = 190.0F, kMostWide = 320.0F;
constexpr float kSmaller = 0.75F;  // where there is no room for that
constexpr float kStep = 4.0F;
constexpr float kHair = 0.01F;  // so that rounding puts nothing into the margin
constexpr ImU32 kHalo = IM_COL32(8, 10, 14, 150);

constexpr float kLeastMark = 3.5F, kMostMark = 9.0F;  // radii, of no load and of the limit

// On whole pixels, so that the picture ends where its frame does.
Area on_pixels(const Canvas& canvas, const Area& area) {
  const float pixel = canvas.unit(1.0F, 0.0F).x;
  const auto snapped = [pixel](const ImVec2& of) {
    return ImVec2{std::round(of.x / pixel) * pixel, std::round(of.y / pixel) * pixel};
  };
  return {snapped(area.at), snapped(area.size)};
}

// A disc as large as the force, and an arrow along the normal.
void draw_touch(const Canvas& canvas, ImVec2 at, ImVec2 tip, float load, float size) {
  const float radius =
      size * (kLeastMark + (kMostMark - kLeastMark) * std::sqrt(std::clamp(load, 0.0F, 1.0F)));
  const ImU32 colour = load_colour(canvas.colours(), load);
  const float dx = tip.x - at.x, dy = tip.y - at.y, length = std::hypot(dx, dy);
  canvas.line(at, tip, kHalo, 5.0F * size);
  canvas.line(at, tip, colour, 2.4F * size);
  if (length > 1.0F) {
    const float x = dx / length, y = dy / length, head = 7.0F * size;
    canvas.triangle({tip.x + x * head, tip.y + y * head}, {tip.x - y * 0.6F * head, tip.y + x * 0.6F * head},
                    {tip.x + y * 0.6F * head, tip.y - x * 0.6F * head}, colour);
  }
  canvas.disc(at, radius + 1.5F, kHalo);
  canvas.disc(at, radius, colour);
  canvas.circle(at, radius, theme::kText, 1.2F);
}

// Around the view, inside of it, in whole pixels: smoothed, its outermost ones would be of another colour.
void draw_edge(const Canvas& canvas, const Area& view) {
  const auto [at, size] = view;
  const float pixel = canvas.unit(1.0F, 0.0F).x, width = std::max(1.0F, std::round(2.0F / pixel)) * pixel;
  canvas.box(at, {size.x, width}, theme::kSecondary, 0.0F);
  canvas.box({at.x, at.y + size.y - width}, {size.x, width}, theme::kSecondary, 0.0F);
  canvas.box(at, {width, size.y}, theme::kSecondary, 0.0F);
  canvas.box({at.x + size.x - width, at.y}, {width, size.y}, theme::kSecondary, 0.0F);
}

}  // namespace

// As large as there is room for: at the right, as low as the panels there leave it, or else at the left.
Area second_view_area(const Canvas& canvas, const OverlayState& state) {
  if (!state.second_view || state.busy || state.start || state.debrief || state.keys_visible) return {};
  const std::vector<Area> taken = fixed_areas(canvas, state);
  const float wanted = std::clamp(kShare * canvas.width(), kLeastWide, kMostWide);
  for (const float width : {wanted, kSmaller * wanted})
    for (const bool at_right : {true, false}) {
      const ImVec2 size{width, std::round(width / kAspect)};
      const float x = at_right ? canvas.width() - theme::kMargin - size.x - kHair : theme::kMargin;
      for (float y = canvas.height() - theme::kMargin - size.y - kHair; y >= theme::kMargin; y -= kStep)
        if (is_clear(canvas, {{x, y}, size}, taken)) return on_pixels(canvas, {{x, y}, size});
    }
  return {};
}

void draw_second_view(const Canvas& canvas, const OverlayState& state) {
  const Area area = second_view_area(canvas, state);
  const ImVec2 at = area.at, size = area.size;
  if (!(size.x > 0.0F)) return;
  for (const TouchMark& touch : state.second_view->touches) {
    const auto inside = [](const glm::vec2& place) {
      return place.x >= 0.0F && place.y >= 0.0F && place.x <= 1.0F && place.y <= 1.0F;
    };
    if (!inside(touch.place) || !inside(touch.tip)) continue;
    const auto place = [&](const glm::vec2& of) {
      return ImVec2{at.x + size.x * of.x, at.y + size.y * of.y};
    };
    draw_touch(canvas, place(touch.place), place(touch.tip), touch.load, 0.6F);
  }
  draw_edge(canvas, area);
  ImFont* font = canvas.fonts().small;
  const std::string name = canvas.fitted(font, state.second_view->name, size.x - 24.0F);
  const ImVec2 words = canvas.measure(font, name);
  canvas.box({at.x + 1.0F, at.y + 1.0F}, {words.x + 14.0F, words.y + 6.0F}, theme::kCard, 0.0F);
  canvas.text(font, {at.x + 8.0F, at.y + 4.0F}, theme::kText, name);
}

void draw_touches(const Canvas& canvas, const OverlayState& state) {
  for (const TouchMark& touch : state.touches)
    draw_touch(canvas, canvas.unit(touch.place.x, touch.place.y), canvas.unit(touch.tip.x, touch.tip.y),
               touch.load, 1.0F);
}

}  // namespace fulcrum::ui
