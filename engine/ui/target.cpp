// The way to the next checkpoint, over the picture: what is hidden in the scene is seen through what hides
// it.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <span>

#include "engine/ui/areas.h"
#include "engine/ui/columns.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

constexpr ImU32 kHalo = IM_COL32(8, 10, 14, 150);  // around lines, so that they are seen on white enamel, too
constexpr ImU32 kLine = IM_COL32(255, 255, 255, 190);
constexpr float kLeastRing = 11.0F;
constexpr float kArrow = 15.0F;      // from its middle to its tip
constexpr float kMark = 4.5F;        // of the touch point
constexpr float kDepthSide = 18.0F;  // from the touch point to the arrow of the depth
constexpr float kDepthHead = 9.0F;   // its length, and 2/3 of its width
constexpr float kPi = std::numbers::pi_v<float>;

ImVec2 moved(ImVec2 from, const glm::vec2& way, float length) {
  return {from.x + way.x * length, from.y + way.y * length};
}

Area around(ImVec2 middle, float radius) {
  return {{middle.x - radius, middle.y - radius}, {2.0F * radius, 2.0F * radius}};
}

void haloed_line(const Canvas& canvas, ImVec2 from, ImVec2 to, float width) {
  canvas.line(from, to, kHalo, width + 2.5F);
  canvas.line(from, to, kLine, width);
}

void dashed_line(const Canvas& canvas, ImVec2 from, ImVec2 to) {
  constexpr float dash = 7.0F, period = 12.0F;
  const glm::vec2 whole(to.x - from.x, to.y - from.y);
  const float length = glm::length(whole);
  if (!(length > 0.0F)) return;
  // Where a line goes far beyond the picture its dashes are longer, so that there are never many.
  const float stretch = std::max(1.0F, length / 2000.0F);
  for (float at = 0.0F; at < length; at += period * stretch)
    haloed_line(canvas, moved(from, whole / length, at),
                moved(from, whole / length, std::min(at + dash * stretch, length)), 1.4F);
}

std::string distance_words(double distance_m) {
  char text[32];
  const double mm = 1e3 * distance_m;
  std::snprintf(text, sizeof text,
                mm < 10.0     ? "%.1f mm"
                : mm < 1000.0 ? "%.0f mm"
                              : "%.2f m",
                mm < 1000.0 ? mm : distance_m);
  return text;
}

std::string note_of(const Target& target) {
  if (!target.dwelling || !(target.dwell_s > 0.0)) {
    std::string distance = distance_words(target.at.distance);
    if (!target.at.farther) return distance;
    const double depth = target.at.farther->depth;
    return distance + ", " + distance_words(std::abs(depth)) + (depth > 0.0 ? " farther" : " nearer");
  }
  char text[48];
  std::snprintf(text, sizeof text, "%.1f of %.3g s", static_cast<double>(target.progress) * target.dwell_s,
                target.dwell_s);
  return text;
}

ImVec2 unit(const Canvas& canvas, const glm::vec2& px) {
  return canvas.unit(px.x, px.y);
}

float ring_radius(const Canvas& canvas, const Target& target) {
  const float seen = canvas.unit(target.at.radius, 0.0F).x + 3.0F;
  return std::clamp(seen, kLeastRing, canvas.height());
}

void draw_ring(const Canvas& canvas, ImVec2 middle, float radius, const Target& target) {
  const ImU32 colour = target.dwelling ? canvas.colours().warn : canvas.colours().accent;
  canvas.arc(middle, radius, 0.0F, 2.0F * kPi, kHalo, 6.0F);
  canvas.arc(middle, radius, 0.0F, 2.0F * kPi, colour, 2.4F);
  if (!target.dwelling || !(target.progress > 0.0F)) return;
  const float outside = radius + 6.0F;
  const float end = -kPi / 2.0F + 2.0F * kPi * std::clamp(target.progress, 0.0F, 1.0F);
  canvas.arc(middle, outside, 0.0F, 2.0F * kPi, kHalo, 5.0F);
  canvas.arc(middle, outside, -kPi / 2.0F, end, canvas.colours().warn, 4.0F);
}

// From the picture's edge inwards, to the first place that is clear.
ImVec2 arrow_place(const Canvas& canvas, const glm::vec2& place, const glm::vec2& way,
                   std::span<const Area> taken) {
  const ImVec2 edge = unit(canvas, place);
  const float farthest = std::hypot(edge.x - canvas.width() / 2.0F, edge.y - canvas.height() / 2.0F);
  for (float back = kArrow; back < farthest; back += 4.0F) {
    const ImVec2 at = moved(edge, way, -back);
    if (is_clear(canvas, around(at, kArrow), taken)) return at;
  }
  return moved(edge, way, -kArrow);
}

void draw_arrow(const Canvas& canvas, ImVec2 middle, const glm::vec2& way, ImU32 colour) {
  const glm::vec2 side(-way.y, way.x);
  const auto drawn = [&](float size, ImU32 filled) {
    const ImVec2 back = moved(middle, way, -0.7F * size);
    canvas.triangle(moved(middle, way, size), moved(back, side, 0.8F * size), moved(back, side, -0.8F * size),
                    filled);
  };
  drawn(kArrow + 4.0F, kHalo);
  drawn(kArrow, colour);
}

// Its name and what is to be said of it, beside it.
Area draw_label(const Canvas& canvas, ImVec2 middle, float radius, const Target& target,
                std::span<const Area> taken) {
  const Fonts& fonts = canvas.fonts();
  const std::string note = " \u00B7 " + note_of(target);
  const float note_width = canvas.measure(fonts.body, note).x;
  const float room = std::max(40.0F, canvas.width() - 2.0F * margin_of(canvas.height()) - note_width - 20.0F);
  const std::string name = canvas.fitted(fonts.strong, target.name, room);
  const ImVec2 words = canvas.measure(fonts.strong, name);
  const Area area =
      clear_beside(canvas, middle, radius, {words.x + note_width + 20.0F, words.y + 10.0F}, taken);
  if (!(area.size.x > 0.0F)) return area;  // the list has it, too
  canvas.card(area.at, area.size);
  canvas.text(fonts.strong, {area.at.x + 10.0F, area.at.y + 5.0F}, theme::kText, name);
  canvas.text(fonts.body, {area.at.x + 10.0F + words.x, area.at.y + 5.0F},
              target.dwelling ? canvas.colours().warn : theme::kSecondary, note);
  return area;
}

Area draw_name(const Canvas& canvas, ImVec2 beside, float radius, const std::string& called,
               std::span<const Area> taken) {
  ImFont* font = canvas.fonts().body;
  const std::string name = canvas.fitted(font, called, 0.5F * canvas.width());
  const ImVec2 words = canvas.measure(font, name);
  const Area area = clear_beside(canvas, beside, radius, {words.x + 20.0F, words.y + 10.0F}, taken);
  if (!(area.size.x > 0.0F)) return area;
  canvas.card(area.at, area.size);
  canvas.text(font, {area.at.x + 10.0F, area.at.y + 5.0F}, theme::kText, name);
  return area;
}

// The way to a tool that is out of the picture; what it takes of the picture is taken.
void draw_lost_tool(const Canvas& canvas, const EdgePlace& tool, std::vector<Area>& taken) {
  const ImVec2 middle = arrow_place(canvas, tool.place, tool.way, taken);
  draw_arrow(canvas, middle, tool.way, theme::kText);
  taken.push_back(around(middle, kArrow));
  taken.push_back(draw_name(canvas, middle, kArrow + 4.0F, tool.name, taken));
}

// In theme units; none: it is not in the picture.
std::optional<ImVec2> touch_point(const Canvas& canvas, const Target& target) {
  if (!target.at.touch) return std::nullopt;
  const ImVec2 at = unit(canvas, *target.at.touch);
  const bool inside = at.x >= 0.0F && at.y >= 0.0F && at.x <= canvas.width() && at.y <= canvas.height();
  return inside ? std::optional(at) : std::nullopt;
}

void draw_touch_point(const Canvas& canvas, ImVec2 at, const std::string& called,
                      std::span<const Area> taken) {
  canvas.disc(at, kMark + 1.5F, kHalo);
  canvas.disc(at, kMark, IM_COL32_WHITE);
  canvas.disc(at, kMark - 2.0F, canvas.colours().accent);
  if (!called.empty()) draw_name(canvas, at, kMark + 8.0F, called, taken);
}

// Beside the touch point, upwards where the target is farther: as long as a drag that takes the tool so deep,
// and no longer than the picture has room for.
Area draw_depth(const Canvas& canvas, ImVec2 touch, float drag) {
  const float side = touch.x + kDepthSide + theme::kMargin < canvas.width() ? kDepthSide : -kDepthSide;
  const ImVec2 foot{touch.x + side, touch.y};
  const ImVec2 tip{foot.x, std::clamp(foot.y - drag, std::min(foot.y, theme::kMargin),
                                      std::max(foot.y, canvas.height() - theme::kMargin))};
  const float back = drag > 0.0F ? kDepthHead : -kDepthHead;
  const auto drawn = [&](float more, ImU32 colour) {
    const float width = 2.4F + more, half = kDepthHead * 2.0F / 3.0F + more / 2.0F;
    canvas.line({foot.x - half, foot.y}, {foot.x + half, foot.y}, colour, width);
    if (std::abs(tip.y - foot.y) > kDepthHead) canvas.line(foot, {tip.x, tip.y + 0.5F * back}, colour, width);
    const float end = more / 2.0F * (drag > 0.0F ? 1.0F : -1.0F);
    canvas.triangle({tip.x, tip.y - end}, {tip.x + half, tip.y + back + end},
                    {tip.x - half, tip.y + back + end}, colour);
  };
  drawn(3.0F, kHalo);
  drawn(0.0F, theme::kDepth);
  const float top = std::min(foot.y, tip.y), bottom = std::max(foot.y, tip.y + kDepthHead);
  return {{foot.x - kDepthHead, top}, {2.0F * kDepthHead, bottom - top}};
}

}  // namespace

void draw_way(const Canvas& canvas, const OverlayState& state) {
  if (!state.target || state.target->dwelling) return;
  const TargetPlace& at = state.target->at;
  if (at.drop) haloed_line(canvas, unit(canvas, at.drop->from), unit(canvas, at.drop->to), 1.6F);
  if (at.level) dashed_line(canvas, unit(canvas, at.level->from), unit(canvas, at.level->to));
}

void draw_target(const Canvas& canvas, const OverlayState& state) {
  if (!state.target && !state.tool) return;
  std::vector<Area> taken = panel_areas(canvas, state);
  if (state.tool) draw_lost_tool(canvas, *state.tool, taken);
  if (!state.target) return;
  const Target& target = *state.target;
  ImVec2 middle = unit(canvas, target.at.place);
  float radius = kArrow + 4.0F;
  if (target.at.in_sight) {
    radius = ring_radius(canvas, target);
    draw_ring(canvas, middle, radius, target);
    if (target.dwelling) radius += 8.0F;
  } else {
    middle = arrow_place(canvas, target.at.place, target.at.way, taken);
    draw_arrow(canvas, middle, target.at.way, canvas.colours().accent);
  }
  const std::optional<ImVec2> touch = touch_point(canvas, target);
  std::vector<Area> marked = taken;
  if (touch && !target.dwelling) marked.push_back(around(*touch, kMark));
  if (touch && target.at.farther && !target.dwelling) {
    taken.push_back(draw_depth(canvas, *touch, canvas.unit(0.0F, target.at.farther->drag).y));
    marked.push_back(taken.back());
  }
  taken.push_back(draw_label(canvas, middle, radius, target, marked));
  taken.push_back(around(middle, radius));
  if (!touch) return;
  draw_touch_point(canvas, *touch, target.touch_name, taken);
}

}  // namespace fulcrum::ui
