#include "engine/ui/areas.h"

#include <algorithm>

#include "engine/ui/columns.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

constexpr float kGap = 6.0F;    // between what is drawn beside each other
constexpr float kStep = 24.0F;  // by which a place farther away is tried
constexpr int kSteps = 14;

bool crowd(const Area& a, const Area& b) {
  return a.at.x < b.at.x + b.size.x + kGap && b.at.x < a.at.x + a.size.x + kGap &&
         a.at.y < b.at.y + b.size.y + kGap && b.at.y < a.at.y + a.size.y + kGap;
}

}  // namespace

std::vector<Area> fixed_areas(const Canvas& canvas, const OverlayState& state) {
  std::vector<Area> areas;
  const Columns columns = columns_of(canvas, state);
  for (const Area& area :
       {checkpoints_area(canvas, state), trouble_area(canvas, state), message_area(canvas, state),
        returning_area(canvas, state), columns.health, columns.cues, columns.holding, columns.motors,
        columns.dials, columns.timeline, columns.band})
    if (area.size.x > 0.0F) areas.push_back(area);
  return areas;
}

std::vector<Area> panel_areas(const Canvas& canvas, const OverlayState& state) {
  std::vector<Area> areas = fixed_areas(canvas, state);
  if (const Area area = second_view_area(canvas, state); area.size.x > 0.0F) areas.push_back(area);
  return areas;
}

bool is_clear(const Canvas& canvas, const Area& area, std::span<const Area> taken) {
  const float margin = margin_of(canvas.height());
  const bool inside = area.at.x >= margin && area.at.y >= margin &&
                      area.at.x + area.size.x <= canvas.width() - margin &&
                      area.at.y + area.size.y <= canvas.height() - margin;
  return inside && std::ranges::none_of(taken, [&](const Area& other) { return crowd(area, other); });
}

Area clear_beside(const Canvas& canvas, ImVec2 middle, float radius, ImVec2 size,
                  std::span<const Area> taken) {
  for (int step = 0; step < kSteps; ++step) {
    const float reach = radius + kGap + kStep * static_cast<float>(step);
    const ImVec2 places[] = {{middle.x + reach, middle.y - size.y / 2.0F},
                             {middle.x - reach - size.x, middle.y - size.y / 2.0F},
                             {middle.x - size.x / 2.0F, middle.y - reach - size.y},
                             {middle.x - size.x / 2.0F, middle.y + reach}};
    for (const ImVec2& place : places)
      if (is_clear(canvas, {place, size}, taken)) return {place, size};
  }
  return {};
}

}  // namespace fulcrum::ui
