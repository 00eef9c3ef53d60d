// What an author drags: a diamond at each place, and its name where there is room for it.

#include <span>

#include "engine/ui/areas.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

constexpr float kDiamond = 6.0F;                  // from its middle to its corners
constexpr ImU32 kRim = IM_COL32(8, 10, 14, 210);  // around it, so that it is seen on white, too
constexpr ImU32 kPlain = IM_COL32(236, 240, 245, 255);

void diamond(const Canvas& canvas, ImVec2 at, float reach, ImU32 colour) {
  const float seam = 0.5F;  // the halves overlap, or what is behind would be seen between them
  canvas.triangle({at.x - reach, at.y + seam}, {at.x, at.y - reach}, {at.x + reach, at.y + seam}, colour);
  canvas.triangle({at.x + reach, at.y - seam}, {at.x, at.y + reach}, {at.x - reach, at.y - seam}, colour);
}

void mark(const Canvas& canvas, const HandleMark& handle, std::vector<Area>& named) {
  const ImVec2 at = canvas.unit(handle.place.x, handle.place.y);
  diamond(canvas, at, kDiamond + 2.0F, kRim);
  diamond(canvas, at, kDiamond, handle.chosen ? canvas.colours().accent : kPlain);
  ImFont* font = canvas.fonts().small;
  const ImVec2 words = canvas.measure(font, handle.name);
  const ImVec2 size{words.x + 8.0F, words.y + 4.0F};
  const float beside = kDiamond + 5.0F;
  for (const float x : {at.x + beside, at.x - beside - size.x}) {
    const Area area{{x, at.y - 0.5F * size.y}, size};
    if (!is_clear(canvas, area, named)) continue;
    named.push_back(area);
    canvas.box(area.at, area.size, theme::kCard, 3.0F);
    canvas.text(font, {x + 4.0F, area.at.y + 2.0F}, handle.chosen ? theme::kText : theme::kSecondary,
                handle.name);
    return;
  }
}

}  // namespace

void draw_handles(const Canvas& canvas, const OverlayState& state) {
  std::vector<Area> named;
  for (const bool chosen : {true, false})
    for (const HandleMark& handle : state.handles)
      if (handle.chosen == chosen) mark(canvas, handle, named);
}

}  // namespace fulcrum::ui
